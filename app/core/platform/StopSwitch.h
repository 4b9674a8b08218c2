// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <mutex>
#include <set>
#include <string>

namespace app {

/// Engages STOP on robots without waiting for the thread that steps their platforms, which may be blocked by
/// a program that hangs: on a real robot at once; on a simulated one by ending the wait. Any thread; engage()
/// waits for nothing but another call. May outlive the robots, whose owner calls forget().
class StopSwitch {
 public:
  /// `act` may be called in any thread and must not block.
  StopSwitch(std::string robot, std::function<void(bool engaged)> act)
      : StopSwitch(std::set<std::string>{std::move(robot)}, std::move(act)) {}
  StopSwitch(std::set<std::string> robots, std::function<void(bool engaged)> act)
      : robots_(std::move(robots)), act_(std::move(act)) {}

  /// Has no effect for other robots than those of the constructor.
  void engage(const std::string& robot, bool engaged) {
    const std::lock_guard lock(mutex_);
    if (act_ && robots_.contains(robot)) act_(engaged);
  }
  /// The robots are gone; later calls of engage() have no effect.
  void forget() {
    const std::lock_guard lock(mutex_);
    act_ = {};
  }

 private:
  const std::set<std::string> robots_;
  /// Protects act_.
  std::mutex mutex_;
  std::function<void(bool)> act_;
};

}  // namespace app
