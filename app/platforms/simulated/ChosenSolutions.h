// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "robotcontrol/Requests.pb.h"

namespace app {

/// Solutions of robots and teams, by their names and by task.
using TeamSolutions = std::map<std::string, std::map<std::string, std::string>>;

/// The solutions that users have chosen while programs run. Any thread.
class ChosenSolutions {
 public:
  /// Call this with each request that a program has fulfilled.
  void note(const robotcontrol::Request& request) {
    if (!request.has_select_solution()) return;
    const std::lock_guard lock(mutex_);
    solutions_[request.robot()][request.select_solution().task()] = request.select_solution().solution();
    isNew_ = true;
  }
  /// Keyed by robot.
  TeamSolutions all() const {
    const std::lock_guard lock(mutex_);
    return solutions_;
  }
  /// Whether one was chosen since this was called last.
  bool takeNews() {
    const std::lock_guard lock(mutex_);
    return std::exchange(isNew_, false);
  }

 private:
  /// Protects the other members.
  mutable std::mutex mutex_;
  TeamSolutions solutions_;
  bool isNew_ = false;
};

}  // namespace app
