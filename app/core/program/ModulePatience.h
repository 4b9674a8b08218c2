// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>

namespace app {

/// The time to wait for modules, in real time. While a STOP request cannot be fulfilled before the wait is
/// over, that is only a moment, and when all programs end, only a moment for all
/// together. Any thread.
class ModulePatience {
 public:
  using Clock = std::chrono::steady_clock;
  /// The longest time for which a STOP waits for a module.
  static constexpr std::chrono::milliseconds kMoment{100};

  explicit ModulePatience(std::chrono::milliseconds usual) : usual_(usual) {}

  std::chrono::milliseconds usual() const { return usual_; }
  /// Call this when a STOP request is waiting for a module to return.
  void cut() { cutAt_.store(Clock::now().time_since_epoch().count()); }
  /// Call this when the STOP request has been fulfilled.
  void restore() { cutAt_.store(0); }
  /// Everything that waits is about to end: all waits, also those that begin later, are over in a moment.
  void end() {
    Clock::rep none = 0;
    endedAt_.compare_exchange_strong(none, Clock::now().time_since_epoch().count());
  }
  /// Whether a wait that began then is over.
  bool isOver(Clock::time_point begin) const {
    const auto now = Clock::now();
    if (now - begin >= usual_) return true;
    const auto endedAt = endedAt_.load(), cutAt = cutAt_.load();
    if (endedAt != 0 && now - Clock::time_point(Clock::duration(endedAt)) >= kMoment) return true;
    return cutAt != 0 && now - std::max(begin, Clock::time_point(Clock::duration(cutAt))) >= kMoment;
  }

 private:
  const std::chrono::milliseconds usual_;
  /// Ticks of the clock; 0: none waits, and nothing ends.
  std::atomic<Clock::rep> cutAt_{0}, endedAt_{0};
};

}  // namespace app
