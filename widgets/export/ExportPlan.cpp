// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/export/ExportPlan.h"

#include <unistd.h>

#include <QRegularExpression>
#include <algorithm>
#include <cmath>

#include "logplayer/pictures/VideoOutput.h"
#include "robotlink/base/ParsedNumber.h"
#include "robotlink/session/Session.h"
#include "widgets/log/ReplayControl.h"

namespace widgets {

namespace fs = std::filesystem;
using robotlink::failure;
using robotlink::Instant;
using robotlink::Result;

namespace {

/// Whether this is the name of one of its images; "field-2-00001.png" is not one of "field".
bool isImageOf(const ExportPlan& plan, std::string_view name) {
  const std::string begin = plan.name + "-";
  constexpr std::string_view kEnd = ".png";
  if (!name.starts_with(begin) || !name.ends_with(kEnd)) return false;
  const std::string_view number = name.substr(begin.size(), name.size() - begin.size() - kEnd.size());
  return !number.empty() && std::ranges::all_of(number, [](char c) { return c >= '0' && c <= '9'; });
}

Result<void> checkFolder(const ExportPlan& plan) {
  std::error_code error;
  fs::create_directories(plan.target, error);
  if (error)
    return failure("file.io", "cannot make the folder: " + error.message(), {plan.target.string(), 0, 0},
                   {error.message()});
  if (::access(plan.target.c_str(), W_OK) != 0)
    return failure("file.io", "nothing can be written into this folder; choose another one",
                   {plan.target.string(), 0, 0});
  for (fs::directory_iterator it(plan.target, error), end; !error && it != end; it.increment(error)) {
    const std::string name = it->path().filename().string();
    if (isImageOf(plan, name))
      return failure("export.exists",
                     "there are images of an earlier export in this folder, such as " + name +
                         "; choose another one, or delete them",
                     {plan.target.string(), 0, 0}, {name});
  }
  return {};
}

Result<void> checkFile(const ExportPlan& plan) {
  if (auto done = logplayer::VideoOutput::checkName(plan.target); !done) return done;
  std::error_code error;
  const fs::path folder = plan.target.has_parent_path() ? plan.target.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error))
    return failure("file.io", "there is no folder " + folder.string(), {plan.target.string(), 0, 0});
  if (::access(folder.c_str(), W_OK) == 0) return {};
  return failure("file.io",
                 "nothing can be written into the folder " + folder.string() + "; choose another one",
                 {plan.target.string(), 0, 0});
}

}  // namespace

std::int64_t ExportPlan::frames() const {
  // A little more, so that the last instant is not lost by rounding.
  const double count = std::floor(robotlink::seconds(to - from) * rate + 1e-6) + 1;
  return std::max<std::int64_t>(1, static_cast<std::int64_t>(std::min(count, 1e15)));
}

Instant ExportPlan::instant(std::int64_t frame) const {
  return std::min(to, from + robotlink::fromSeconds(static_cast<double>(frame) / rate));
}

Result<void> check(const ExportPlan& plan) {
  if (!std::isfinite(plan.rate) || plan.rate < ExportPlan::kMinRate || plan.rate > ExportPlan::kMaxRate)
    return failure("export.rate", "the rate must be 0.1 to 240 pictures a second");
  if (plan.to < plan.from) return failure("export.times", "the end must not be before the beginning");
  if (plan.frames() > ExportPlan::kMaxFrames)
    return failure("export.frames", "these would be " + std::to_string(plan.frames()) +
                                        " pictures, more than " + std::to_string(ExportPlan::kMaxFrames) +
                                        "; choose a shorter time or a lower rate");
  const auto isSide = [](int side) { return side >= ExportPlan::kMinSide && side <= ExportPlan::kMaxSide; };
  if (!isSide(plan.size.width()) || !isSide(plan.size.height()))
    return failure("export.size", "the size must be 16x16 to 8192x8192 pixels");
  return plan.kind == ExportPlan::Kind::kVideo ? checkFile(plan) : checkFolder(plan);
}

std::optional<TimeSpan> exportable(robotlink::Session& session, const ReplayControl& replay) {
  if (replay.open()) return TimeSpan{replay.begin(), replay.end()};
  if (session.store().bytes() == 0) return std::nullopt;
  const auto kept = session.history().kept();
  return TimeSpan{kept.front().from, kept.back().to};
}

std::optional<TimeSpan> chosenSpan(robotlink::Session& session, const ReplayControl& replay) {
  const auto all = exportable(session, replay);
  const auto range = replay.range();
  if (!all || !range) return all;
  return TimeSpan{std::clamp(range->first, all->from, all->to),
                  std::clamp(range->second, all->from, all->to)};
}

Result<Instant> instantOf(const std::string& text, robotlink::Session& session, const ReplayControl& replay) {
  const auto chosen = chosenSpan(session, replay), all = exportable(session, replay);
  if (!chosen || !all)
    return failure("export.nothing",
                   "there is nothing to export: start a simulation, connect to a robot, or open a log");
  if (text == "start") return chosen->from;
  if (text == "end") return chosen->to;
  const auto seconds = robotlink::parsedNumber<double>(text);
  if (!seconds || !std::isfinite(*seconds) || std::abs(*seconds) > 1e9)
    return failure("export.time", "a time is a number of seconds, start or end, not \"" + text + "\"", {},
                   {text});
  const bool fromNow = *seconds < 0 && !replay.open();
  const Instant time = (fromNow ? session.timeline().newest() : session.timeline().origin()) +
                       robotlink::fromSeconds(*seconds);
  // Data at a time counted back from now may be gone by now, and a rounded number may be a little outside.
  const auto slack = std::chrono::milliseconds(fromNow ? 100 : 1);
  if (time >= all->from - slack && time <= all->to + slack) return std::clamp(time, all->from, all->to);
  const auto shown = [&](Instant at) {
    return QString::number(robotlink::seconds(session.timeline().sinceOrigin(at)), 'f', 3).toStdString();
  };
  return failure("export.time",
                 text + " s is not there: it is " + shown(all->from) + " to " + shown(all->to) + " s", {},
                 {text});
}

Result<QSize> sizeOf(const std::string& text, const QSize& usual) {
  if (text.empty()) return usual;
  static const QRegularExpression kSize(QStringLiteral("^(\\d{1,5})x(\\d{1,5})$"));
  const auto match = kSize.match(QString::fromStdString(text));
  if (match.hasMatch()) return QSize(match.captured(1).toInt(), match.captured(2).toInt());
  return failure("export.size", "a size is written as 1280x720, not \"" + text + "\"", {}, {text});
}

}  // namespace widgets
