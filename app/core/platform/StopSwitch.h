// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <mutex>
#include <set>
#include <string>

namespace app {

/// Engages STOP on robots without waiting for the thread that steps their platforms, which may be blocked by
/// a program that hangs: on a real robot at once; on a simulated one by ending the wait. Any thread; engage()
/// waits for nothing but another call. Also ends waits for programs that hang, when the platform is closed.
/// May outlive the robots, whose owner calls forget().
class StopSwitch {
 public:
  /// `act` and `endWaits` may be called in any thread and must not block; `endWaits` may be empty.
  StopSwitch(std::string robot, std::function<void(bool engaged)> act)
      : StopSwitch(std::set<std::string>{std::move(robot)}, std::move(act)) {}
  StopSwitch(std::set<std::string> robots, std::function<void(bool engaged)> act,
             std::function<void()> endWaits = {})
      : robots_(std::move(robots)), act_(std::move(act)), endWaits_(std::move(endWaits)) {}

  /// The robots that there are from now on.
  void setRobots(std::set<std::string> robots) {
    const std::lock_guard lock(mutex_);
    robots_ = std::move(robots);
  }
  /// Has no effect for other robots than those that there are.
  void engage(const std::string& robot, bool engaged) {
    const std::lock_guard lock(mutex_);
    if (act_ && robots_.contains(robot)) act_(engaged);
  }
  /// The platform is about to be closed: programs that hang are not waited for any longer.
  void endWaits() {
    const std::lock_guard lock(mutex_);
    if (endWaits_) endWaits_();
  }
  /// Call this when the robots are removed; later calls of the other functions have no effect.
  void forget() {
    const std::lock_guard lock(mutex_);
    act_ = {};
    endWaits_ = {};
  }

 private:
  /// Protects the other members.
  std::mutex mutex_;
  std::set<std::string> robots_;
  std::function<void(bool)> act_;
  std::function<void()> endWaits_;
};

}  // namespace app
