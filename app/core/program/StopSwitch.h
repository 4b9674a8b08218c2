// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <mutex>
#include <string>

namespace app {

/// STOP of a real robot, for whoever cannot wait until the thread that steps its program has time: that one
/// may be waiting for a program that hangs. Any thread; it waits for nothing. Outlives the robot that it
/// stops, as its owner forgets() that.
class StopSwitch {
 public:
  /// `act` is called in any thread.
  StopSwitch(std::string robot, std::function<void(bool engaged)> act)
      : robot_(std::move(robot)), act_(std::move(act)) {}

  void engage(const std::string& robot, bool engaged) {
    const std::lock_guard lock(mutex_);
    if (act_ && robot == robot_) act_(engaged);
  }
  /// The robot is gone: nothing is stopped any more.
  void forget() {
    const std::lock_guard lock(mutex_);
    act_ = {};
  }

 private:
  const std::string robot_;
  std::mutex mutex_;  // protects act_
  std::function<void(bool)> act_;
};

}  // namespace app
