// SPDX-License-Identifier: GPL-3.0-or-later
// `robotctl log`: the command itself, and what its subcommands share.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <iostream>

#include "app/robotctl/log/LogSubcommands.h"
#include "logplayer/base/LogDates.h"
#include "logplayer/bookmarks/Bookmarks.h"
#include "robotlink/base/ParsedNumber.h"
#include "robotlink/base/Printable.h"

namespace app {
namespace {

using robotlink::Instant;
using robotlink::Result;

constexpr auto kQuiet = std::chrono::milliseconds(500);  // shorter operations show no progress

std::optional<double> numberOf(std::string_view text) {
  constexpr double kLargest = 4e9;  // s; the sum of two fits into an Instant
  const auto number = robotlink::parsedNumber<double>(text);
  return number && std::abs(*number) < kLargest ? number : std::nullopt;
}

Result<Instant> timeOf(const std::string& text, Instant begin,
                       const std::vector<logplayer::Bookmark>& bookmarks, Instant logplayer::Bookmark::*end) {
  if (const auto number = numberOf(text)) return begin + robotlink::fromSeconds(*number);
  if (text.starts_with('@')) {
    if (const auto number = numberOf(text.substr(1))) return Instant(robotlink::fromSeconds(*number));
  }
  if (const auto date = logplayer::instantOfDate(text)) return *date;
  std::string known;
  std::optional<Instant> found;
  for (const auto& bookmark : bookmarks) {
    known += (known.empty() ? "'" : ", '") + bookmark.text + "'";
    if (bookmark.text != text) continue;
    if (found)
      return robotlink::failure("usage", "several bookmarks are called '" + text + "'; give a time instead");
    found = bookmark.*end;
  }
  if (found) return *found;
  return robotlink::failure(
      "usage", "'" + text +
                   "' is neither a time in seconds from the log's start (12.5), nor one of the log " +
                   "(@486.75), nor a date in UTC (2026-05-04T12:30:01.25), nor one of its bookmarks (" +
                   (known.empty() ? "it has none" : known) + ")");
}

}  // namespace

int printLosses(const std::vector<std::string>& losses) {
  for (const std::string& loss : losses) std::cerr << robotlink::printable(loss) << "\n";
  return losses.empty() ? kDone : kDoneWithLosses;
}

void TimeRangeOptions::addTo(CLI::App& command) {
  const char* kinds =
      "in seconds from the log's start, or @ and the log's own time, or a date in UTC (2026-05-04T12:30:01), "
      "or a bookmark's text";
  command.add_option("--from", from, std::string("Where to begin: ") + kinds);
  command.add_option("--to", to, "Where to end, in the same form");
}

Result<TimeRangeOptions::Instants> TimeRangeOptions::of(const std::filesystem::path& log) const {
  Instants result;
  if (from.empty() && to.empty()) return result;
  TerminalProgress progress;
  logplayer::LogFile::Options options;
  options.progress = progress.function();
  const auto file = logplayer::LogFile::open(log, options);
  if (!file) return tl::unexpected(file.error());
  result.log = *file;
  const auto bookmarks = logplayer::Bookmarks::open(log);
  if (!bookmarks) return tl::unexpected(bookmarks.error());
  const auto read = [&](const std::string& text, Instant logplayer::Bookmark::*end,
                        std::optional<Instant>& time) -> Result<void> {
    if (text.empty()) return {};
    const auto found = timeOf(text, (*file)->begin(), bookmarks->all(), end);
    if (!found) return tl::unexpected(found.error());
    time = *found;
    return {};
  };
  if (const auto ok = read(from, &logplayer::Bookmark::from, result.from); !ok)
    return tl::unexpected(ok.error());
  if (const auto ok = read(to, &logplayer::Bookmark::to, result.to); !ok) return tl::unexpected(ok.error());
  if (result.from && result.to && *result.to < *result.from) {
    return robotlink::failure("usage", "--to is before --from");
  }
  return result;
}

int printRangeError(const robotlink::Error& error) {
  printErrors({error});
  return error.id == "usage" ? kUsage : kFailed;
}

TerminalProgress::TerminalProgress()
    : start_(std::chrono::steady_clock::now()), onTerminal_(::isatty(STDERR_FILENO) == 1) {}

TerminalProgress::~TerminalProgress() {
  erase();
}

void TerminalProgress::erase() {
  if (shown_ >= 0) std::fputs("\r       \r", stderr);
  shown_ = -1;
}

logplayer::LogFile::Progress TerminalProgress::function() {
  return [this](double share) { return show(share); };
}

bool TerminalProgress::show(double share) {
  if (Interrupt::noted()) return false;
  const int percent = static_cast<int>(std::clamp(share, 0.0, 1.0) * 100);
  if (!onTerminal_ || percent == shown_ || std::chrono::steady_clock::now() - start_ < kQuiet) return true;
  std::fprintf(stderr, "\r%3d %% ", percent);
  shown_ = percent;
  return true;
}

void addLogCommand(CLI::App& app, int& status) {
  CLI::App* log =
      app.add_subcommand("log", "Describes, checks, converts, cuts, merges, repairs and exports log files");
  log->require_subcommand(1);
  addLogReadCommands(*log, status);
  addLogImportCommands(*log, status);
  addLogCutCommands(*log, status);
  addLogExportCommand(*log, status);
  addLogSearchCommand(*log, status);
  addLogNoteCommands(*log, status);
  addLogFetchCommand(*log, status);
}

}  // namespace app
