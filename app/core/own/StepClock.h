// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>

#include "robotlink/base/Clock.h"

namespace app {

/// The clock of a program in a process of its own: shows the time of the newest step plus, in real time, the
/// time since then. In real time it never goes back. Any thread may call now(), one calls set().
class StepClock final : public robotlink::Clock {
 public:
  explicit StepClock(bool inRealTime) : inRealTime_(inRealTime) {}

  robotlink::Instant now() const override {
    if (!inRealTime_) return robotlink::Instant(robotlink::Duration(time_.load()));
    const std::int64_t time = time_.load() + steady();
    std::int64_t shown = shown_.load();
    while (shown < time && !shown_.compare_exchange_weak(shown, time)) {
    }
    return robotlink::Instant(robotlink::Duration(std::max(shown, time)));
  }
  void set(robotlink::Instant time) {
    time_.store(time.time_since_epoch().count() - (inRealTime_ ? steady() : 0));
  }

 private:
  static std::int64_t steady() {
    return std::chrono::duration_cast<robotlink::Duration>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
  }

  const bool inRealTime_;
  /// Nanoseconds: that of the newest step, in real time less the steady time then.
  std::atomic<std::int64_t> time_{0};
  /// The last instant that was shown in real time.
  mutable std::atomic<std::int64_t> shown_{INT64_MIN};
};

}  // namespace app
