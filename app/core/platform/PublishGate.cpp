// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/platform/PublishGate.h"

#include "foxglove/Robot.pb.h"
#include "logplayer/record/Recorder.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Hosting.pb.h"
#include "robotlink/base/GroundMap.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/process/Process.h"
#include "robotlink/session/QueueMessages.h"
#include "robotlink/session/Session.h"

#include <algorithm>
#include <set>

namespace app {
namespace {

bool hasOnlyFrames(const robotlink::SharedDebugQueue& queue) {
  return std::ranges::all_of(queue.messages, [](const robotlink::SharedDebugMessage& message) {
    return message.as<robotcontrol::FrameInfo>() != nullptr;
  });
}

}  // namespace

void PublishGate::open() {
  const std::lock_guard lock(mutex_);
  open_ = true;
  if (recorder_ != nullptr && !kept_.empty()) recorder_->restart();
  for (const auto& push : kept_) push();
  kept_.clear();
}

void PublishGate::close() {
  const std::lock_guard lock(mutex_);
  open_ = false;
}

void PublishGate::discard() {
  const std::lock_guard lock(mutex_);
  kept_.clear();
}

void PublishGate::pass(std::function<void()> push) {
  {
    const std::lock_guard lock(mutex_);
    if (!open_) {
      kept_.push_back(std::move(push));
      return;
    }
  }
  push();
}

// Messages of frames whose end is missing are recorded outside of frames: after a jump, a replay publishes
// the newest message of each stream, of whatever frame.
void PublishGate::record(std::vector<robotlink::StreamMessage> frame) {
  if (recorder_ == nullptr) return;
  std::set<std::pair<std::string, std::uint64_t>> whole;
  for (const auto& message : frame) {
    if (dynamic_cast<const robotcontrol::FrameInfo*>(message.value.get()) != nullptr)
      whole.emplace(message.process, message.frame);
  }
  for (auto& message : frame) {
    if (!whole.contains({message.process, message.frame})) message.frame = 0;
  }
  recorder_->add(std::move(frame));
}

void PublishGate::recordQueue(const std::string& robot,
                              const std::shared_ptr<const robotlink::SharedDebugQueue>& queue) {
  if (recorder_ == nullptr || !recorder_->active()) return;
  auto parts = robotlink::messagesOf(robot, *queue, {}, robotlink::QueueReader::kRecorder);
  for (auto& frame : robotlink::framesOf(std::move(parts.messages))) record(std::move(frame));
}

void PublishGate::publish(robotlink::StreamMessage message) {
  pass([this, message = std::move(message)]() mutable {
    record({message});
    session_.push(std::move(message));
  });
}

void PublishGate::publishFrame(std::vector<robotlink::StreamMessage> frame) {
  pass([this, frame = std::move(frame)]() mutable {
    record(frame);
    session_.push(std::move(frame));
  });
}

void PublishGate::publishQueue(const std::string& robot,
                               std::shared_ptr<const robotlink::SharedDebugQueue> queue) {
  pass([this, robot, queue = std::move(queue)] {
    recordQueue(robot, queue);
    if (isRead_ || !hasOnlyFrames(*queue)) session_.pushQueue(robot, queue);
  });
}

void PublishGate::publishError(const std::string& robot, const std::string& source, robotlink::Instant time,
                               const std::string& text) {
  publishText(robot, source, time, foxglove::Log::ERROR, text);
}

robotlink::StreamMessage textMessage(const std::string& robot, const std::string& source,
                                     robotlink::Instant time, int level, const std::string& text) {
  auto log = std::make_shared<foxglove::Log>();
  log->set_level(static_cast<foxglove::Log::Level>(level));
  log->set_name(source);
  log->set_message(text);
  robotlink::assign(*log->mutable_timestamp(), time);
  return {robot + "/" + robotlink::streams::kLog, time, std::move(log)};
}

void PublishGate::publishText(const std::string& robot, const std::string& source, robotlink::Instant time,
                              int level, const std::string& text) {
  publish(textMessage(robot, source, time, level, text));
}

void PublishGate::publishMapNotes(const std::string& robot, robotlink::Instant time,
                                  const robotlink::GroundMap& map) {
  const int level = map.incomplete ? foxglove::Log::WARNING : foxglove::Log::INFO;
  for (const std::string& note : map.notes) publishText(robot, "map", time, level, note);
}

void PublishGate::publishPlatform(const std::string& robot, robotlink::Instant time,
                                  const std::string& text) {
  publishPlatformText(robot, time, foxglove::Log::INFO, text);
}

void PublishGate::publishPlatformProblem(const std::string& robot, robotlink::Instant time,
                                         const std::string& text) {
  publishPlatformText(robot, time, foxglove::Log::WARNING, text);
}

void PublishGate::publishPlatformText(const std::string& robot, robotlink::Instant time, int level,
                                      const std::string& text) {
  if (reports_) {
    reports_->push_back(robot + ": " + text);
  } else {
    publishText(robot, robotlink::streams::kPlatformSource, time, level, text);
  }
}

void PublishGate::keepReports() {
  reports_ = std::make_unique<std::vector<std::string>>();
}

void PublishGate::publishHosting(const std::string& robot, robotlink::Instant time,
                                 const robotcontrol::HostingStatus& status) {
  publish({robot + "/" + robotlink::streams::kHosting, time,
           std::make_shared<robotcontrol::HostingStatus>(status)});
  if (status.text().empty()) return;
  const bool runs = status.state() == robotcontrol::HostingStatus::RUNNING;
  publishText(robot, "program", time, runs ? foxglove::Log::INFO : foxglove::Log::ERROR, status.text());
}

void PublishGate::publishTrouble(const std::string& robot, const robotlink::Process& process,
                                 const std::string& text) {
  publishError(robot, process.name(), process.clock().now(), text);
}

}  // namespace app
