// SPDX-License-Identifier: GPL-3.0-or-later
// How a ReplayFeed fulfills requests.
#include "app/platforms/replay/ReplayFeed.h"

#include <algorithm>

#include "app/core/platform/HostingMemory.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/RequestKinds.h"
#include "robotlink/session/Session.h"

namespace app {

using robotcontrol::ControlReplay;
using robotlink::failure;
using robotlink::Instant;
using robotlink::Result;

namespace {

Instant instantOf(std::int64_t time) {
  return Instant(robotlink::Duration(time));
}

}  // namespace

/// The requests that only a log fulfills.
struct ReplayFeed::Handlers {
  using Request = robotcontrol::Request;
  static constexpr robotlink::RequestRow<Result<void> (ReplayFeed::*)(const Request&)> kRows[]{
      {Request::kControlReplay, &ReplayFeed::control}};
};

bool ReplayFeed::fulfills(const robotcontrol::Request& request) {
  return robotlink::rowOf(Handlers::kRows, request.what_case()) != nullptr;
}

Result<void> ReplayFeed::requestReplay(const robotcontrol::Request& request) {
  const auto* row = robotlink::rowOf(Handlers::kRows, request.what_case());
  if (row == nullptr) return failure("replay.request", "a log cannot " + robotlink::inWords(request));
  return (this->*row->handler)(request);
}

Result<void> ReplayFeed::requestSimulation(const robotcontrol::Request& request) {
  if (!request.has_host_program())
    return failure("simulation.none", "a log is open, not a simulation; open a scene first");
  auto done = changed([&] { return run_->hostProgram(request.robot(), request.host_program()); });
  if (done) rememberHosting(hosting_, kAdapter, request.host_program(), run_->options().hosting);
  return done;
}

Result<void> ReplayFeed::requestRobot(const robotcontrol::Request& request) {
  if (request.has_stop()) return stop(request);
  auto done = run_->request(request);
  if (!done) return done;
  stale_ = stale_ || robotlink::kindOf(request).effect != robotlink::RequestEffect::kNone;
  publishAnswers();
  return done;
}

/// The actions of the logged robot cannot be changed, and its program's commands here have no effect. So
/// nothing has to be released.
Result<void> ReplayFeed::stop(const robotcontrol::Request& request) {
  if (!run_->description(request.robot()))
    return failure("request.no-robot", "there is no robot " + request.robot() + " in the logs", {},
                   {request.robot()});
  if (!robotlink::engagesStop(request)) return {};
  playback_.pause();
  publishStatus();
  return {};
}

/// While it is paused, they do not wait until the programs have run again up to here. They are not in the
/// log that a recording of the replay is.
void ReplayFeed::publishAnswers() {
  if (playback_.playing()) return;
  for (const auto& [robot, queue] : run_->answersToCome()) session_.pushQueue(robot, queue);
}

Result<void> ReplayFeed::control(const robotcontrol::Request& request) {
  const ControlReplay& control = request.control_replay();
  if (auto done = set(control); !done) return done;
  if (auto done = change(control); !done) return done;
  const auto done = act(control);
  if (!done || !stale_ || playback_.playing()) return done;
  // The result is published after the effects of all earlier requests.
  return jump(run_->now());
}

Result<void> ReplayFeed::set(const ControlReplay& control) {
  if (control.has_step_process() && !run_->setStepProcess(control.step_process())) {
    return failure("replay.process", "the log has no frames of a process " + control.step_process(), {},
                   {control.step_process()});
  }
  if (control.has_speed()) playback_.setSpeed(control.speed(), Clock::now(), place());
  if (control.has_loop()) playback_.setLoop(control.loop());
  if (control.has_skip_gaps()) playback_.setSkipsGaps(control.skip_gaps());
  if (control.has_range()) {
    const auto inside = [this](std::int64_t time) {
      return std::clamp(instantOf(time), run_->begin(), run_->end());
    };
    const Instant from = inside(control.range().from()), to = inside(control.range().to());
    playback_.setRange(from == to ? std::nullopt
                                  : std::optional(Playback::Range{std::min(from, to), std::max(from, to)}));
  }
  return {};
}

Result<void> ReplayFeed::change(const ControlReplay& control) {
  if (control.packages_size() > 0) {
    std::map<std::string, ControlReplay::PackageSource> packages;
    for (const auto& choice : control.packages()) packages[choice.package()] = choice.source();
    if (auto done = changed([&] { return run_->choosePackages(packages); }); !done) return done;
  }
  if (control.offsets_size() == 0) return {};
  std::map<std::filesystem::path, robotlink::Duration> offsets;
  for (const auto& offset : control.offsets()) {
    const auto& logs = run_->options().logs;
    const bool known = std::ranges::any_of(logs, [&](const auto& log) { return log.file == offset.log(); });
    if (!known)
      return failure("replay.log", offset.log() + " is not open", {offset.log(), 0, 0}, {offset.log()});
    offsets[offset.log()] = robotlink::Duration(offset.offset());
  }
  return changed([&] { return run_->setOffsets(offsets); });
}

Result<void> ReplayFeed::act(const ControlReplay& control) {
  switch (control.action()) {
    case ControlReplay::PLAY:
      return play();
    case ControlReplay::PAUSE:
      playback_.pause();
      return {};
    case ControlReplay::STOP:
      playback_.pause();
      return jump(firstImage());
    case ControlReplay::STEP_FRAME:
      return stepFrames(control);
    case ControlReplay::STEP_MESSAGE:
      return stepMessages(control);
    case ControlReplay::JUMP_TO_TIME:
      return jump(instantOf(control.time()));
    case ControlReplay::JUMP_TO_FRAME:
      return jumpToFrame(control);
    case ControlReplay::ADVANCE_TO_TIME:
      playback_.pause();
      return goTo(std::clamp(instantOf(control.time()), run_->begin(), run_->end()));
    default:
      return {};
  }
}

Result<void> ReplayFeed::play() {
  if (playback_.playing()) return {};
  if (!run_->nextTime() && !playback_.loop()) {
    if (auto done = jump(firstImage()); !done) return done;
  }
  playback_.play(Clock::now(), place());
  return {};
}

bool ReplayFeed::leads(Instant to, int count) const {
  return count < 0 ? to < run_->now() : to > run_->now();
}

Result<void> ReplayFeed::stepFrames(const ControlReplay& control) {
  playback_.pause();
  const std::string& process = control.process().empty() ? run_->stepProcess() : control.process();
  const auto time = run_->frameTime(process, control.count());
  if (!time) return failure("replay.process", "the log has no frames of a process " + process, {}, {process});
  return leads(*time, control.count()) ? goTo(*time) : Result<void>();
}

Result<void> ReplayFeed::stepMessages(const ControlReplay& control) {
  playback_.pause();
  const auto time = run_->messageTime(control.stream(), control.count());
  if (time && leads(*time, control.count())) return goTo(*time);
  const std::string where = control.count() < 0 ? "before" : "after";
  return failure("replay.stream", where + " here the log has no message of " + control.stream(), {},
                 {control.stream()});
}

Result<void> ReplayFeed::jumpToFrame(const ControlReplay& control) {
  const std::string& process = control.process().empty() ? run_->stepProcess() : control.process();
  const auto time = run_->timeOfFrame(process, control.frame());
  if (time) return jump(*time);
  const std::string frame = std::to_string(control.frame());
  return failure("replay.frame", "the log has no frame " + frame + " of " + process, {}, {frame, process});
}

}  // namespace app
