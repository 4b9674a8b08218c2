// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/program/RecordingTap.h"

#include <algorithm>
#include <set>

#include "app/core/program/HostedProgram.h"
#include "app/core/program/ProgramSetups.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/session/LatchedMessages.h"
#include "robotlink/session/QueueMessages.h"

namespace app {

using robotlink::SharedDebugMessage;
using robotlink::SharedDebugQueue;
using robotlink::StreamMessage;

namespace {

/// The name of the platform as a process in logs.
constexpr char kPlatform[] = "platform";

/// The messages that the senders of one process have sent in its current frame. Only used in the thread of
/// that process.
struct TappedFrame {
  std::string robot;
  std::string process;
  std::vector<StreamMessage> messages;
  /// The streams that are recorded by taps. Debug queues may contain them, too; they are skipped there.
  std::set<std::string> paths;
};

/// Taps all senders of a process except those of packages for debugging. The taps share ownership of the
/// frame, since the senders may outlive the program.
void tapSenders(const robotlink::Process& process, const std::shared_ptr<TappedFrame>& frame,
                const logplayer::Recorder& recorder) {
  for (robotlink::AnySender* sender : process.senders()) {
    if (sender->package().starts_with("debug/")) continue;
    const std::string path = frame->robot + "/" + sender->package();
    frame->paths.insert(path);
    sender->addTap([&recorder, frame, path, from = &process](const robotlink::PackagePtr& package) {
      StreamMessage message{path, from->clock().now(), package, frame->process, from->frames() + 1};
      if (recorder.active() || robotlink::isLatched(message)) frame->messages.push_back(std::move(message));
    });
  }
}

StreamMessage frameInfo(const std::string& robot, const std::string& process, robotlink::Instant time,
                        std::uint64_t number) {
  auto info = std::make_shared<robotcontrol::FrameInfo>();
  robotlink::assign(*info->mutable_timestamp(), time);
  info->set_process(process);
  info->set_number(number);
  return {robot + "/" + robotlink::streams::kFrames + process, time, std::move(info), process, number};
}

/// Whether a debug queue contains latched messages, which the recorder needs even while it does not record.
bool recordsLatched(const SharedDebugQueue& queue) {
  return std::ranges::any_of(queue.messages, [](const SharedDebugMessage& message) {
    return message.content &&
           robotlink::isLatched(message.path, message.content->GetDescriptor()->full_name());
  });
}

}  // namespace

struct RecordingTap::Robot {
  std::string name;
  robotlink::Platform* platform = nullptr;
  HostedProgram* program = nullptr;
  /// The packages that the user chose to have published.
  std::set<std::string> chosen;
  /// The packages that the program was requested to publish.
  std::set<std::string> asked;
  /// The packages that the platform sends.
  std::shared_ptr<TappedFrame> sensors = std::make_shared<TappedFrame>();
  /// The packages that the debug process sends on behalf of the user.
  std::shared_ptr<TappedFrame> debugPackages = std::make_shared<TappedFrame>();

  // Only in the debug process's thread:
  robotcontrol::ProgramSetup setup;
  robotlink::Instant lastTime;

  StreamMessage setupMessage(robotlink::Instant time) const {
    return {name + "/" + robotlink::streams::kProgram, time,
            std::make_shared<robotcontrol::ProgramSetup>(setup)};
  }
  /// The packages of the program that the user or the recorder wants now.
  std::set<std::string> wanted(const logplayer::Recorder& recorder) const {
    std::set<std::string> packages = chosen;
    for (const std::string& package : program->yieldedPackages()) {
      if (recorder.wants(name + "/" + package)) packages.insert(package);
    }
    return packages;
  }
  /// Requests packages from the program; false if it takes no requests now. Other details than the packages
  /// are those of `request`.
  bool ask(std::set<std::string> packages, robotcontrol::Request request) {
    request.set_robot(name);
    auto& details = *request.mutable_record_packages();
    details.mutable_packages()->Assign(packages.begin(), packages.end());
    if (!program->request(request)) return false;
    asked = std::move(packages);
    return true;
  }
};

RecordingTap::~RecordingTap() = default;

RecordingTap::Robot* RecordingTap::find(const std::string& name) const {
  for (const auto& robot : robots_) {
    if (robot->name == name) return robot.get();
  }
  return nullptr;
}

void RecordingTap::attach(const std::string& name, robotlink::Platform& platform, HostedProgram& program,
                          robotcontrol::ProgramSetup setup) {
  auto robot = std::make_shared<Robot>();
  robot->name = name;
  robot->platform = &platform;
  robot->program = &program;
  robot->setup = std::move(setup);
  robot->lastTime = platform.clock().now();
  robot->sensors->robot = robot->debugPackages->robot = name;
  robot->sensors->process = kPlatform;
  robot->debugPackages->process = program.debugProcess().name();
  if (const Robot* before = find(name); before != nullptr && before->platform == &platform) {
    robot->sensors = before->sensors;
    std::erase_if(robots_, [&](const auto& other) { return other->name == name; });
  } else {
    tapSenders(platform, robot->sensors, recorder_);
  }
  tapSenders(program.debugProcess(), robot->debugPackages, recorder_);
  robot->asked = robot->wanted(recorder_);
  program.recordPackages(robot->asked);
  recorder_.forget(name);
  recorder_.add({robot->setupMessage(platform.clock().now())});
  robots_.push_back(std::move(robot));
}

void RecordingTap::detach(const std::string& name) {
  std::erase_if(robots_, [&](const auto& robot) { return robot->name == name; });
}

void RecordingTap::askForPackages() {
  const std::uint64_t demand = recorder_.demand();
  if (demand == demand_) return;
  for (const auto& robot : robots_) {
    std::set<std::string> packages = robot->wanted(recorder_);
    // Too many requests may be waiting: try again at the next step.
    if (packages != robot->asked && !robot->ask(std::move(packages), {})) return;
  }
  demand_ = demand;
}

void RecordingTap::endStep() {
  for (const auto& robot : robots_) {
    std::vector<StreamMessage> messages = std::exchange(robot->sensors->messages, {});
    if (messages.empty()) continue;
    messages.push_back(frameInfo(robot->name, kPlatform, messages.back().time, messages.back().frame));
    recorder_.add(std::move(messages));
  }
}

bool RecordingTap::request(const std::string& name, const robotcontrol::Request& request) {
  Robot* robot = find(name);
  if (robot == nullptr) return false;
  if (request.has_record_packages()) {
    const auto& packages = request.record_packages().packages();
    robot->chosen = {packages.begin(), packages.end()};
    return robot->ask(robot->wanted(recorder_), request);
  }
  if (!robot->program->request(request)) return false;
  if (recorder_.active()) {
    recorder_.add({{name + "/" + robotlink::streams::kRequests, robot->platform->clock().now(),
                    std::make_shared<robotcontrol::Request>(request)}});
  }
  return true;
}

void RecordingTap::world(StreamMessage message) {
  if (recorder_.active() || robotlink::isLatched(message)) recorder_.add({std::move(message)});
}

void RecordingTap::add(const std::string& name, const std::shared_ptr<const SharedDebugQueue>& queue) {
  Robot* robot = find(name);
  if (robot == nullptr) return;
  bool setupChanged = false;
  for (const SharedDebugMessage& message : queue->messages) setupChanged |= follow(robot->setup, message);
  const bool own = queue->process == robot->debugPackages->process;
  if (recorder_.active() || recordsLatched(*queue) || (own && !robot->debugPackages->messages.empty())) {
    auto parts = robotlink::messagesOf(name, *queue, robot->lastTime, robotlink::QueueReader::kRecorder);
    if (!parts.messages.empty()) robot->lastTime = parts.messages.back().time;
    for (std::vector<StreamMessage>& frame : robotlink::framesOf(std::move(parts.messages))) {
      std::erase_if(frame, [robot](const StreamMessage& message) {
        return robot->sensors->paths.contains(message.path) ||
               robot->debugPackages->paths.contains(message.path);
      });
      // Insert what the debug process sent in this frame before the frame's end.
      if (own && !frame.empty()) {
        auto debugPackages = std::exchange(robot->debugPackages->messages, {});
        frame.insert(frame.end() - 1, std::make_move_iterator(debugPackages.begin()),
                     std::make_move_iterator(debugPackages.end()));
      }
      recorder_.add(std::move(frame));
    }
  }
  if (setupChanged) recorder_.add({robot->setupMessage(robot->lastTime)});
}

}  // namespace app
