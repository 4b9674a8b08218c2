// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/base/LogDates.h"

#include <fmt/format.h>

#include <charconv>
#include <chrono>

namespace logplayer {

using robotlink::Instant;

namespace {

using Days = std::chrono::sys_days;

constexpr Days kFirst = std::chrono::year(2000) / 1 / 1;
constexpr Days kEnd = std::chrono::year(2100) / 1 / 1;

Instant instantOf(Days day) {
  return Instant(std::chrono::duration_cast<robotlink::Duration>(day.time_since_epoch()));
}

/// Parses a number with a fixed number of digits; empty if there is none.
std::optional<int> takeNumber(std::string_view& text, std::size_t digits) {
  int number = 0;
  if (text.size() < digits) return std::nullopt;
  const auto [end, error] = std::from_chars(text.data(), text.data() + digits, number);
  if (error != std::errc() || end != text.data() + digits || number < 0) return std::nullopt;
  text.remove_prefix(digits);
  return number;
}

bool take(std::string_view& text, std::string_view any) {
  if (text.empty() || any.find(text.front()) == std::string_view::npos) return false;
  text.remove_prefix(1);
  return true;
}

std::optional<Days> takeDay(std::string_view& text) {
  const auto year = takeNumber(text, 4);
  if (!year || !take(text, "-")) return std::nullopt;
  const auto month = takeNumber(text, 2);
  if (!month || !take(text, "-")) return std::nullopt;
  const auto day = takeNumber(text, 2);
  if (!day) return std::nullopt;
  const std::chrono::year_month_day date{std::chrono::year(*year),
                                         std::chrono::month(static_cast<unsigned>(*month)),
                                         std::chrono::day(static_cast<unsigned>(*day))};
  if (!date.ok()) return std::nullopt;
  return Days(date);
}

/// Parses the digits after a decimal point.
std::optional<robotlink::Duration> takeFraction(std::string_view& text) {
  std::int64_t nanoseconds = 0, unit = 100'000'000;
  if (text.empty() || text.front() < '0' || text.front() > '9') return std::nullopt;
  for (; !text.empty() && text.front() >= '0' && text.front() <= '9'; text.remove_prefix(1), unit /= 10) {
    nanoseconds += unit * (text.front() - '0');
  }
  return robotlink::Duration(nanoseconds);
}

std::optional<robotlink::Duration> takeTimeOfDay(std::string_view& text) {
  const auto hour = takeNumber(text, 2);
  if (!hour || *hour > 23 || !take(text, ":")) return std::nullopt;
  const auto minute = takeNumber(text, 2);
  if (!minute || *minute > 59) return std::nullopt;
  robotlink::Duration time = std::chrono::hours(*hour) + std::chrono::minutes(*minute);
  if (!take(text, ":")) return time;
  const auto second = takeNumber(text, 2);
  if (!second || *second > 60) return std::nullopt;
  time += std::chrono::seconds(*second);
  if (!take(text, ".")) return time;
  const auto fraction = takeFraction(text);
  return fraction ? std::optional(time + *fraction) : std::nullopt;
}

}  // namespace

bool isDate(Instant time) {
  return instantOf(kFirst) <= time && time < instantOf(kEnd);
}

std::string dateText(Instant time) {
  const std::chrono::sys_time<robotlink::Duration> whole{time.time_since_epoch()};
  const Days day = std::chrono::floor<std::chrono::days>(whole);
  const std::chrono::year_month_day date{day};
  const std::chrono::hh_mm_ss clock{whole - day};
  return fmt::format("{:04}-{:02}-{:02} {:02}:{:02}:{:02}.{:03} UTC", static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                     clock.hours().count(), clock.minutes().count(), clock.seconds().count(),
                     clock.subseconds().count() / 1'000'000);
}

std::string dateOrSeconds(Instant time) {
  return isDate(time) ? dateText(time) : fmt::format("{:.3f} s", robotlink::seconds(time));
}

std::optional<Instant> instantOfDate(std::string_view text) {
  const auto day = takeDay(text);
  if (!day) return std::nullopt;
  const Instant start = instantOf(*day);
  if (text.empty()) return start;
  if (!take(text, " T")) return std::nullopt;
  const auto time = takeTimeOfDay(text);
  if (!time) return std::nullopt;
  if (text == " UTC") text = {};
  take(text, "Z");
  return text.empty() ? std::optional(start + *time) : std::nullopt;
}

}  // namespace logplayer
