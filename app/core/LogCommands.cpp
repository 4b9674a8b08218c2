// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/LogCommands.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/core/CommandValues.h"
#include "app/core/LogWriteJob.h"
#include "app/core/OpenPlatform.h"
#include "app/core/program/ShippedFiles.h"
#include "logplayer/base/RecordedStreams.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/base/ParsedNumber.h"
#include "robotlink/debugging/RequestKinds.h"
#include "robotlink/debugging/Streams.h"

namespace app {
namespace {

using robotcontrol::ControlReplay;
using robotcontrol::ReplayStatus;
using robotlink::CommandTable;
using robotlink::failure;
using robotlink::Result;

/// The open logs, as the commands need them. A handle; copies refer to the same platform.
class Logs {
 public:
  explicit Logs(OpenPlatform& open) : open_(&open) {}

  OpenPlatform& open() const { return *open_; }
  /// The last published status. Fails if no log is open.
  Result<const ReplayStatus*> status() const {
    auto& session = open_->session();
    const auto* status =
        session.store().latestAs<ReplayStatus>(robotlink::streams::kReplay, session.timeline().newest());
    if (status == nullptr) return failure("log.none", "no log is open; open one first: log.open FILE");
    return status;
  }
  /// Sends a request to the replay.
  Result<void> control(const ControlReplay& control) const {
    robotcontrol::Request request;
    *request.mutable_control_replay() = control;
    open_->ask(std::move(request));
    return {};
  }
  /// The same for an action without arguments.
  Result<void> act(ControlReplay::Action action) const {
    ControlReplay control;
    control.set_action(action);
    return this->control(control);
  }

 private:
  OpenPlatform* open_;
};

/// Returns the number of steps from a command's argument.
Result<std::int32_t> wholeCount(double value) {
  constexpr double kMax = std::numeric_limits<std::int32_t>::max();
  if (value == 0 || std::trunc(value) != value || std::abs(value) > kMax) {
    return failure("log.count", "the count must be a whole number other than 0; negative counts go backward");
  }
  return static_cast<std::int32_t>(value);
}

/// Converts seconds since the beginning to a time of the timeline, in ns. Fails if that is outside.
Result<std::int64_t> timeAt(const ReplayStatus& status, double seconds) {
  const double length = 1e-9 * static_cast<double>(status.end() - status.begin());
  if (!(seconds >= 0 && seconds <= length)) {
    return failure("log.time", "the time must be between 0 and " + std::to_string(length) +
                                   " seconds, which is how long the log is");
  }
  return std::min(status.end(), status.begin() + robotlink::fromSeconds(seconds).count());
}

/// Converts seconds to add to a log's times. Fails if they exceed any possible difference of clocks.
Result<robotlink::Duration> offsetOf(double seconds) {
  if (std::abs(seconds) <= robotlink::kMaxLogOffset) return robotlink::fromSeconds(seconds);
  return failure("log.offset", "the offset must be a number of seconds, and at most 100 years");
}

/// Returns the path of an open log by the name of its file; otherwise the argument as it is.
std::string logNamed(const std::string& name, const ReplayStatus& status) {
  for (const auto& log : status.logs()) {
    if (std::filesystem::path(log.path()).filename() == name) return log.path();
  }
  return name;
}

void addOpening(CommandTable& commands, const Logs& logs) {
  commands.attach("log.add", [logs](const Values& values) -> Result<void> {
    const auto offset = offsetOf(number(values, 1));
    if (!offset) return tl::unexpected(offset.error());
    logs.open().addLog(text(values, 0), *offset);
    return {};
  });
  commands.attach("log.cancel", [logs](const Values&) -> Result<void> {
    logs.open().cancelOpening();
    return {};
  });
  commands.attach("log.close", [logs](const Values&) -> Result<void> {
    if (auto status = logs.status(); !status) return tl::unexpected(status.error());
    logs.open().close();
    return {};
  });
  commands.attach("log.offset", [logs](const Values& values) -> Result<void> {
    const auto status = logs.status();
    if (!status) return tl::unexpected(status.error());
    const auto offset = offsetOf(number(values, 1));
    if (!offset) return tl::unexpected(offset.error());
    ControlReplay control;
    control.add_offsets()->set_log(logNamed(text(values, 0), **status));
    control.mutable_offsets(0)->set_offset(offset->count());
    return logs.control(control);
  });
}

void addPlaying(CommandTable& commands, const Logs& logs) {
  const auto action = [&](const char* name, ControlReplay::Action what) {
    commands.attach(name, [logs, what](const Values&) { return logs.act(what); });
  };
  action("log.play", ControlReplay::PLAY);
  action("log.pause", ControlReplay::PAUSE);
  action("log.stop", ControlReplay::STOP);
  commands.attach("log.speed", [logs](const Values& values) -> Result<void> {
    const std::string wrong = robotlink::wrongSpeed(number(values, 0), robotlink::kReplaySpeeds);
    if (!wrong.empty()) return failure("log.speed", wrong);
    ControlReplay control;
    control.set_speed(number(values, 0));
    return logs.control(control);
  });
  const auto option = [&](const char* name, void (ControlReplay::*set)(bool)) {
    commands.attach(name, [logs, set](const Values& values) {
      ControlReplay control;
      (control.*set)(std::get<bool>(values[0]));
      return logs.control(control);
    });
  };
  option("log.loop", &ControlReplay::set_loop);
  option("log.skip-gaps", &ControlReplay::set_skip_gaps);
  commands.attach("log.range", [logs](const Values& values) -> Result<void> {
    const auto status = logs.status();
    if (!status) return tl::unexpected(status.error());
    const auto from = timeAt(**status, number(values, 0)), to = timeAt(**status, number(values, 1));
    if (!from || !to) return tl::unexpected(from ? to.error() : from.error());
    ControlReplay control;
    control.mutable_range()->set_from(std::min(*from, *to));
    control.mutable_range()->set_to(std::max(*from, *to));
    return logs.control(control);
  });
}

void addStepping(CommandTable& commands, const Logs& logs) {
  commands.attach("log.step", [logs](const Values& values) -> Result<void> {
    const auto count = wholeCount(number(values, 0));
    if (!count) return tl::unexpected(count.error());
    ControlReplay control;
    control.set_action(ControlReplay::STEP_FRAME);
    control.set_count(*count);
    return logs.control(control);
  });
  commands.attach("log.step-message", [logs](const Values& values) -> Result<void> {
    const auto count = wholeCount(number(values, 1));
    if (!count) return tl::unexpected(count.error());
    ControlReplay control;
    control.set_action(ControlReplay::STEP_MESSAGE);
    control.set_stream(text(values, 0));
    control.set_count(*count);
    return logs.control(control);
  });
  commands.attach("log.step-process", [logs](const Values& values) {
    ControlReplay control;
    control.set_step_process(text(values, 0));
    return logs.control(control);
  });
}

void addJumping(CommandTable& commands, const Logs& logs) {
  commands.attach("log.jump", [logs](const Values& values) -> Result<void> {
    const auto status = logs.status();
    if (!status) return tl::unexpected(status.error());
    const auto time = timeAt(**status, number(values, 0));
    if (!time) return tl::unexpected(time.error());
    ControlReplay control;
    control.set_action(ControlReplay::JUMP_TO_TIME);
    control.set_time(*time);
    return logs.control(control);
  });
  commands.attach("log.jump-frame", [logs](const Values& values) -> Result<void> {
    // Above this, not every whole number is a double.
    constexpr double kMax = 9e15;
    const double frame = number(values, 0);
    if (!(frame >= 0 && frame <= kMax) || std::trunc(frame) != frame) {
      return failure("log.frame", "a frame number must be a whole number, 0 or more");
    }
    ControlReplay control;
    control.set_action(ControlReplay::JUMP_TO_FRAME);
    control.set_frame(static_cast<std::uint64_t>(frame));
    return logs.control(control);
  });
}

/// Returns a package's name with its robot; the selected robot's if the name has none.
std::string packageNamed(const std::string& name, const ReplayStatus& status, const std::string& robot) {
  const auto known = [&](const std::string& path) {
    return std::ranges::any_of(status.packages(),
                               [&](const auto& package) { return package.package() == path; });
  };
  return !known(name) && known(robot + "/" + name) ? robot + "/" + name : name;
}

Result<void> choosePackage(const Logs& logs, const std::string& name, const std::string& source) {
  const auto status = logs.status();
  if (!status) return tl::unexpected(status.error());
  ControlReplay control;
  auto& choice = *control.add_packages();
  choice.set_package(packageNamed(name, **status, logs.open().session().selectedRobot()));
  if (source == "logged") {
    choice.set_source(ControlReplay::AS_LOGGED);
  } else if (source == "recomputed") {
    choice.set_source(ControlReplay::RECOMPUTED);
  } else {
    choice.set_source(ControlReplay::AUTOMATIC);
  }
  return logs.control(control);
}

void addProgram(CommandTable& commands, const Logs& logs) {
  commands.attach("log.package", [logs](const Values& values) {
    return choosePackage(logs, text(values, 0), text(values, 1));
  });
  commands.attach("log.layout", [logs](const Values& values) -> Result<void> {
    if (const auto status = logs.status(); !status) return tl::unexpected(status.error());
    logs.open().setLayout(layoutNamed(text(values, 0)));
    return {};
  });
}

/// A range of the timeline; unset where it is open.
struct TimeRange {
  std::optional<robotlink::Instant> from, to;
};

/// "start", "end", or seconds since the beginning.
Result<std::optional<robotlink::Instant>> endOfRange(const ReplayStatus& status, const std::string& text) {
  if (text == "start" || text == "end") return std::nullopt;
  const auto seconds = robotlink::parsedNumber<double>(text);
  if (!seconds)
    return failure("log.time", "a time is in seconds since the start, or start or end, not '" + text + "'");
  const auto time = timeAt(status, *seconds);
  if (!time) return tl::unexpected(time.error());
  return robotlink::Instant(robotlink::Duration(*time));
}

Result<TimeRange> timesOfPart(const ReplayStatus& status, const std::string& from, const std::string& to) {
  if (from == "end" || to == "start")
    return failure("log.time", "the range must not begin at the end or end at the start");
  const auto first = endOfRange(status, from);
  const auto last = endOfRange(status, to);
  if (!first || !last) return tl::unexpected(first ? last.error() : first.error());
  if (*first && *last && **last < **first) return TimeRange{*last, *first};
  return TimeRange{*first, *last};
}

Result<void> cut(const Logs& logs, LogWriteJob& job, const Values& values) {
  const auto status = logs.status();
  if (!status) return tl::unexpected(status.error());
  const auto range = timesOfPart(**status, text(values, 1), text(values, 2));
  if (!range) return tl::unexpected(range.error());
  const auto selection = logplayer::readSelection(text(values, 3));
  if (!selection) return tl::unexpected(selection.error());
  logplayer::RewriteOptions options;
  for (const auto& log : (*status)->logs())
    options.inputs.push_back({log.path(), robotlink::Duration(log.offset())});
  options.from = range->from;
  options.to = range->to;
  options.streams.include = {selection->include().begin(), selection->include().end()};
  options.streams.exclude = {selection->exclude().begin(), selection->exclude().end()};
  return job.cut(std::move(options), text(values, 0));
}

LogWriteJob::Export::Kind exportKind(const std::string& name) {
  using enum LogWriteJob::Export::Kind;
  return name == "images" ? kImages : name == "csv" ? kCsv : name == "json" ? kJson : kTexts;
}

Result<void> exportLog(const Logs& logs, LogWriteJob& job, const Values& values) {
  const auto status = logs.status();
  if (!status) return tl::unexpected(status.error());
  const auto range = timesOfPart(**status, text(values, 3), text(values, 4));
  if (!range) return tl::unexpected(range.error());
  const std::string wanted = logNamed(text(values, 5), **status);
  const auto& open = (*status)->logs();
  const auto log = wanted.empty()
                       ? open.begin()
                       : std::ranges::find_if(open, [&](const auto& each) { return each.path() == wanted; });
  if (log == open.end()) return failure("log.unknown", "no log " + wanted + " is open", {}, {wanted});
  LogWriteJob::Export what{.kind = exportKind(text(values, 0)),
                           .log = log->path(),
                           .streams = text(values, 1),
                           .target = text(values, 2)};
  const robotlink::Duration offset(log->offset());
  if (range->from) what.from = *range->from - offset;
  if (range->to) what.to = *range->to - offset;
  return job.exportLog(std::move(what));
}

/// The names of the files of the open logs.
std::vector<std::string> logNames(const Logs& logs) {
  std::vector<std::string> names;
  const auto status = logs.status();
  if (!status) return names;
  for (const auto& log : (*status)->logs())
    names.push_back(std::filesystem::path(log.path()).filename().string());
  return names;
}

}  // namespace

void addLogWriting(CommandTable& commands, OpenPlatform& open, LogWriteJob& job) {
  const Logs logs(open);
  commands.attach("log.cut", [logs, &job](const Values& values) { return cut(logs, job, values); });
  commands.attach(
      "log.export", [logs, &job](const Values& values) { return exportLog(logs, job, values); },
      [logs](const auto& before) {
        return before.size() == 5 ? logNames(logs) : std::vector<std::string>();
      });
}

Result<std::vector<std::filesystem::path>> openLogs(OpenPlatform& open) {
  const auto status = Logs(open).status();
  if (!status) return tl::unexpected(status.error());
  std::vector<std::filesystem::path> files;
  for (const auto& log : (*status)->logs()) files.emplace_back(log.path());
  return files;
}

void addLogCommands(CommandTable& commands, OpenPlatform& open) {
  const Logs logs(open);
  addOpening(commands, logs);
  addPlaying(commands, logs);
  addStepping(commands, logs);
  addJumping(commands, logs);
  addProgram(commands, logs);
}

}  // namespace app
