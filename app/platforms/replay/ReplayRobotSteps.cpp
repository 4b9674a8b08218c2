// SPDX-License-Identifier: GPL-3.0-or-later
// How a ReplayRobot runs over its log.
#include <algorithm>

#include "app/core/program/ColorTables.h"
#include "app/platforms/replay/ReplayRobot.h"
#include "robotcontrol/Driving.pb.h"
#include "robotcontrol/Motion.pb.h"
#include "robotlink/debugging/RequestKinds.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/debugging/program/RobotProgram.h"

namespace app {

namespace streams = robotlink::streams;

using robotcontrol::ProgramSetup;
using robotcontrol::Request;
using robotlink::Instant;
using robotlink::StreamMessage;

// ---- Running it

bool ReplayRobot::computes() const {
  const auto& all = plan().layout.processes;
  return std::ranges::any_of(all, [](const auto& process) { return !process.tasks.empty(); });
}

std::string ReplayRobot::whyNotDoneBy(const std::string& task, const std::string& solution) const {
  for (const auto& process : plan().layout.processes) {
    for (const auto& entry : process.tasks) {
      if (entry.task != task || entry.solution == solution) continue;
      const auto found = plan().replaced.find(task);
      return found != plan().replaced.end() ? found->second : "it is unavailable here";
    }
  }
  return {};
}

std::vector<std::string> ReplayRobot::neededStreams() const {
  std::vector<std::string> needed;
  for (const std::string& path : streams_) {
    // Logged packages are needed even if they are recomputed: they are compared.
    const bool needs = logged_.contains(path) || path.starts_with(streams::kFrames) ||
                       path == streams::kRequests || path == streams::kProgram ||
                       robotlink::isDebugPackage(path);
    if (needs) needed.push_back(logName_ + "/" + path);
  }
  return needed;
}

void ReplayRobot::take(Instant now, const std::vector<StreamMessage>& messages) {
  clock_.set(now);
  bool startedOver = false;
  for (const StreamMessage& message : messages) {
    const auto* setup = dynamic_cast<const ProgramSetup*>(message.value.get());
    const bool isSetup = setup != nullptr && below(message.path) == streams::kProgram;
    if (isSetup && takeSetup(*setup, now)) startedOver = true;
  }
  // Meanwhile the module may return at any time, and use what is given to it.
  if (host_.isStuck()) return;
  host_.enqueueRequests();
  for (const StreamMessage& message : messages) {
    const std::string path = below(message.path);
    // Packages of the instant of a restart belong to the previous program.
    if (logged_.contains(path) && !startedOver) takePackage(path, message);
    const auto* request = dynamic_cast<const Request*>(message.value.get());
    if (request != nullptr && path == streams::kRequests) takeRequest(*request);
    if (!hasRequests() && robotlink::isDebugPackage(path)) takeRequest(*message.value);
  }
  // Requests take effect when the debug process ran in the recording. Here it runs at every instant, so that
  // what programs publish is seen at once.
  if (!debugProcessRan(messages)) return;
  for (const Request& request : std::exchange(due_, {})) (void)host_.program()->request(request);
}

bool ReplayRobot::debugProcessRan(const std::vector<StreamMessage>& messages) const {
  for (const auto& process : setup().layout.processes) {
    const std::string frames = streams::kFrames + process.name;
    if (!process.debug || !streams_.contains(frames)) continue;
    return std::ranges::any_of(messages,
                               [&](const StreamMessage& message) { return below(message.path) == frames; });
  }
  // The log does not say.
  return true;
}

void ReplayRobot::takePackage(const std::string& package, const StreamMessage& message) {
  if (started_.platform->put(package, message.value)) return;
  if (countsDifferences_ && !plan().isAsLogged(package)) differences_.addLogged(package, message.value);
}

bool ReplayRobot::takeSetup(const ProgramSetup& setup, Instant now) {
  if (!started_.logged || !isAnotherProgram(*started_.logged, setup)) return false;
  auto start = prepare(now, choices());
  if (!start) {
    host_.reportTrouble(*host_.platform(),
                        "cannot be restarted as in the log: " + robotlink::describe(start.error()));
    return false;
  }
  adopt(std::move(*start));
  return true;
}

// The user's present overrides take precedence over requests of the recording. Requests that only concern
// views do not matter.
void ReplayRobot::takeRequest(const Request& request) {
  const robotlink::RequestKind& kind = robotlink::kindOf(request);
  const bool runs = kind.task == nullptr || plan().runs(kind.task(request));
  const bool matters = kind.isOfProgram() && kind.effect == robotlink::RequestEffect::kBehavior;
  if (!matters || !runs || host_.overrides().contains(request)) return;
  due_.push_back(request);
  due_.back().clear_id();
  due_.back().set_robot(name());
  if (request.has_set_color_table() && !request.set_color_table().table().cells().empty())
    *due_.back().mutable_set_color_table()->mutable_table() =
        colorTableOfLog(request.set_color_table().table());
}

void ReplayRobot::takeRequest(const google::protobuf::Message& package) {
  Request request;
  if (const auto* texts = dynamic_cast<const robotcontrol::MotionTexts*>(&package)) {
    for (const auto& motion : texts->motions()) {
      *request.mutable_set_motion()->mutable_motion() = motion;
      takeRequest(request);
    }
    return;
  }
  if (const auto* motion = dynamic_cast<const robotcontrol::RemoteMotion*>(&package)) {
    *request.mutable_motion() = *motion;
  } else if (const auto* goal = dynamic_cast<const robotcontrol::DriveGoal*>(&package)) {
    *request.mutable_set_goal() = *goal;
  } else if (const auto* table = dynamic_cast<const robotcontrol::ColorTable*>(&package)) {
    *request.mutable_set_color_table()->mutable_table() = *table;
  }
  takeRequest(request);
}

void ReplayRobot::run() {
  leftOver_.forgetEnded();
  const bool wasStuck = host_.isStuck();
  if (!wasStuck && choices().hosting.patience.count() > 0) events_.beginTurn();
  executor_->stepFromSensors();
  // The events of a module that does not return wait until it does.
  if (!host_.isStuck()) events_.endTurn();
  if (countsDifferences_ && !wasStuck) {
    differences_.endInstant(clock_.now());
  } else {
    differences_.dropInstant();
  }
}

StreamMessage ReplayRobot::published(StreamMessage message) const {
  const std::string path = below(message.path);
  const bool isRecomputed = paths_.isRecomputed(path, *message.value);
  message.path = name() + "/" + (isRecomputed ? streams::kLogged : "") + path;
  // The process counts its frames from zero here. Drawings are matched to frames by their times.
  if (!isRecomputed && paths_.runs(message.process)) message.frame = 0;
  return message;
}

}  // namespace app
