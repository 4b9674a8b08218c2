// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/LogCommands.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/core/CommandValues.h"
#include "app/core/OpenPlatform.h"
#include "app/core/program/ShippedFiles.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/RequestKinds.h"
#include "robotlink/debugging/Streams.h"

namespace app {
namespace {

using robotcontrol::ControlReplay;
using robotcontrol::ReplayStatus;
using robotlink::CommandTable;
using robotlink::failure;
using robotlink::Result;
using Type = CommandTable::Type;

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

/// Converts seconds since the beginning to a time of the time line, in ns. Fails if that is outside.
Result<std::int64_t> timeAt(const ReplayStatus& status, double seconds) {
  const double length = 1e-9 * static_cast<double>(status.end() - status.begin());
  if (!(seconds >= 0 && seconds <= length)) {
    return failure("log.time", "the time must be between 0 and " + std::to_string(length) +
                                   " seconds, which is how long the log is");
  }
  return std::min(status.end(), status.begin() + robotlink::fromSeconds(seconds).count());
}

/// Converts seconds that are to be added to a log's times. Fails for so many that no clocks differ by them.
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
  commands.add({"log.add",
                "Adds a log file to the timeline",
                {{"file", Type::kText, "a log file"},
                 {"offset", Type::kNumber,
                  "seconds to add to its times; 0: it starts with the first log unless their times overlap"}},
                [logs](const Values& values) -> Result<void> {
                  const auto offset = offsetOf(number(values, 1));
                  if (!offset) return tl::unexpected(offset.error());
                  logs.open().addLog(text(values, 0), *offset);
                  return {};
                }});
  commands.add({"log.cancel",
                "Cancels opening a log, map or scene; what ran before continues",
                {},
                [logs](const Values&) -> Result<void> {
                  logs.open().cancelOpening();
                  return {};
                }});
  commands.add({"log.close", "Closes the open logs", {}, [logs](const Values&) -> Result<void> {
                  if (auto status = logs.status(); !status) return tl::unexpected(status.error());
                  logs.open().close();
                  return {};
                }});
  commands.add(
      {"log.offset",
       "Shifts one of the open logs on the timeline",
       {{"file", Type::kText, "an open log file"}, {"offset", Type::kNumber, "seconds to add to its times"}},
       [logs](const Values& values) -> Result<void> {
         const auto status = logs.status();
         if (!status) return tl::unexpected(status.error());
         const auto offset = offsetOf(number(values, 1));
         if (!offset) return tl::unexpected(offset.error());
         ControlReplay control;
         control.add_offsets()->set_log(logNamed(text(values, 0), **status));
         control.mutable_offsets(0)->set_offset(offset->count());
         return logs.control(control);
       }});
}

void addPlaying(CommandTable& commands, const Logs& logs) {
  const auto action = [&](const char* name, const char* help, ControlReplay::Action what) {
    commands.add({name, help, {}, [logs, what](const Values&) { return logs.act(what); }});
  };
  action("log.play", "Plays the log; at its end, from the start", ControlReplay::PLAY);
  action("log.pause", "Pauses the log", ControlReplay::PAUSE);
  action("log.stop", "Pauses the log at its start", ControlReplay::STOP);
  commands.add({"log.speed",
                "Sets how many times real time the log is played",
                {{"speed", Type::kNumber, "times real time, 0.05 to 50"}},
                [logs](const Values& values) -> Result<void> {
                  const std::string wrong =
                      robotlink::wrongSpeed(number(values, 0), robotlink::kReplaySpeeds);
                  if (!wrong.empty()) return failure("log.speed", wrong);
                  ControlReplay control;
                  control.set_speed(number(values, 0));
                  return logs.control(control);
                }});
  const auto option = [&](const char* name, const char* help, const char* argument,
                          void (ControlReplay::*set)(bool)) {
    commands.add({name, help, {{"on", Type::kBool, argument}}, [logs, set](const Values& values) {
                    ControlReplay control;
                    (control.*set)(std::get<bool>(values[0]));
                    return logs.control(control);
                  }});
  };
  option("log.loop", "Loops the whole log or the selected range", "off pauses at the end",
         &ControlReplay::set_loop);
  option("log.skip-gaps", "Skips gaps of more than a second in the log", "off plays them at normal speed",
         &ControlReplay::set_skip_gaps);
  commands.add(
      {"log.range",
       "Selects a range, for example to loop it; equal times clear the selection",
       {{"from", Type::kNumber, "seconds since the start"}, {"to", Type::kNumber, "seconds since the start"}},
       [logs](const Values& values) -> Result<void> {
         const auto status = logs.status();
         if (!status) return tl::unexpected(status.error());
         const auto from = timeAt(**status, number(values, 0)), to = timeAt(**status, number(values, 1));
         if (!from || !to) return tl::unexpected(from ? to.error() : from.error());
         ControlReplay control;
         control.mutable_range()->set_from(std::min(*from, *to));
         control.mutable_range()->set_to(std::max(*from, *to));
         return logs.control(control);
       }});
}

void addStepping(CommandTable& commands, const Logs& logs) {
  commands.add({"log.step",
                "Pauses the log and steps by frames of the chosen process",
                {{"count", Type::kNumber, "how many; negative: backward"}},
                [logs](const Values& values) -> Result<void> {
                  const auto count = wholeCount(number(values, 0));
                  if (!count) return tl::unexpected(count.error());
                  ControlReplay control;
                  control.set_action(ControlReplay::STEP_FRAME);
                  control.set_count(*count);
                  return logs.control(control);
                }});
  commands.add({"log.step-message",
                "Pauses the log and steps by messages of a stream",
                {{"stream", Type::kText, "its path: red1/camera/image"},
                 {"count", Type::kNumber, "how many; negative: backward"}},
                [logs](const Values& values) -> Result<void> {
                  const auto count = wholeCount(number(values, 1));
                  if (!count) return tl::unexpected(count.error());
                  ControlReplay control;
                  control.set_action(ControlReplay::STEP_MESSAGE);
                  control.set_stream(text(values, 0));
                  control.set_count(*count);
                  return logs.control(control);
                }});
  commands.add({"log.step-process",
                "Chooses the process whose frames are stepped and counted",
                {{"process", Type::kText, "red1/cognition"}},
                [logs](const Values& values) {
                  ControlReplay control;
                  control.set_step_process(text(values, 0));
                  return logs.control(control);
                }});
}

void addJumping(CommandTable& commands, const Logs& logs) {
  commands.add({"log.jump",
                "Jumps to a time of the log",
                {{"seconds", Type::kNumber, "since the start"}},
                [logs](const Values& values) -> Result<void> {
                  const auto status = logs.status();
                  if (!status) return tl::unexpected(status.error());
                  const auto time = timeAt(**status, number(values, 0));
                  if (!time) return tl::unexpected(time.error());
                  ControlReplay control;
                  control.set_action(ControlReplay::JUMP_TO_TIME);
                  control.set_time(*time);
                  return logs.control(control);
                }});
  commands.add({"log.jump-frame",
                "Jumps to a frame of the chosen process",
                {{"number", Type::kNumber, "of the frame, as the process counted"}},
                [logs](const Values& values) -> Result<void> {
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
                }});
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
  } else if (source == "automatic") {
    choice.set_source(ControlReplay::AUTOMATIC);
  } else {
    return failure("log.package-source",
                   "the source of a package must be logged, recomputed or automatic, not \"" + source + "\"",
                   {}, {source});
  }
  return logs.control(control);
}

void addProgram(CommandTable& commands, const Logs& logs) {
  commands.add(
      {"log.package",
       "Chooses whether a package is taken from the log or recomputed by the program that runs on it",
       {{"name", Type::kText, "models/ball, or with the robot red1/models/ball"},
        {"source", Type::kText, "logged, recomputed or automatic"}},
       [logs](const Values& values) { return choosePackage(logs, text(values, 0), text(values, 1)); }});
  commands.add({"log.layout",
                "Restarts the program on the log in another process layout, given by its path or the name of "
                "a shipped one",
                {{"layout", Type::kText, "a layout file"}},
                [logs](const Values& values) -> Result<void> {
                  if (const auto status = logs.status(); !status) return tl::unexpected(status.error());
                  logs.open().setLayout(layoutNamed(text(values, 0)));
                  return {};
                }});
}

}  // namespace

void addLogCommands(CommandTable& commands, OpenPlatform& open) {
  const Logs logs(open);
  addOpening(commands, logs);
  addPlaying(commands, logs);
  addStepping(commands, logs);
  addJumping(commands, logs);
  addProgram(commands, logs);
}

}  // namespace app
