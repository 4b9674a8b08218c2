// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/Outlet.h"

#include "foxglove/Robot.pb.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/process/Process.h"
#include "robotlink/session/Session.h"

namespace app {

void Outlet::open() {
  const std::lock_guard lock(mutex_);
  open_ = true;
  for (const auto& push : kept_) push();
  kept_.clear();
}

void Outlet::close() {
  const std::lock_guard lock(mutex_);
  open_ = false;
}

void Outlet::discard() {
  const std::lock_guard lock(mutex_);
  kept_.clear();
}

void Outlet::pass(std::function<void()> push) {
  {
    const std::lock_guard lock(mutex_);
    if (!open_) {
      kept_.push_back(std::move(push));
      return;
    }
  }
  push();
}

void Outlet::tell(robotlink::StreamMessage message) {
  pass([this, message = std::move(message)]() mutable { session_.push(std::move(message)); });
}

void Outlet::tellFrame(std::vector<robotlink::StreamMessage> frame) {
  pass([this, frame = std::move(frame)]() mutable { session_.push(std::move(frame)); });
}

void Outlet::tellQueue(const std::string& robot, std::shared_ptr<const robotcontrol::DebugQueue> queue) {
  pass([this, robot, queue = std::move(queue)] { session_.pushQueue(robot, queue); });
}

void Outlet::tellError(const std::string& robot, const std::string& source, robotlink::Instant time,
                       const std::string& text) {
  auto log = std::make_shared<foxglove::Log>();
  log->set_level(foxglove::Log::ERROR);
  log->set_name(source);
  log->set_message(text);
  robotlink::assign(*log->mutable_timestamp(), time);
  tell({robot + "/" + robotlink::streams::kLog, time, std::move(log)});
}

void Outlet::tellTrouble(const std::string& robot, const robotlink::Process& process, const std::string& text) {
  tellError(robot, process.name(), process.clock().now(), text);
}

}  // namespace app
