// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <mutex>
#include <string>

namespace app {

/// Engages STOP on a real robot without waiting for the thread that steps its platform, which may be blocked
/// by a program that hangs. Any thread; engage() waits for nothing but another call. May outlive the robot,
/// whose owner calls forget().
class StopSwitch {
 public:
  /// `act` may be called in any thread and must not block.
  StopSwitch(std::string robot, std::function<void(bool engaged)> act)
      : robot_(std::move(robot)), act_(std::move(act)) {}

  /// Has no effect for other robots than the one of the constructor.
  void engage(const std::string& robot, bool engaged) {
    const std::lock_guard lock(mutex_);
    if (act_ && robot == robot_) act_(engaged);
  }
  /// The robot is gone; later calls of engage() have no effect.
  void forget() {
    const std::lock_guard lock(mutex_);
    act_ = {};
  }

 private:
  const std::string robot_;
  /// Protects act_.
  std::mutex mutex_;
  std::function<void(bool)> act_;
};

}  // namespace app
