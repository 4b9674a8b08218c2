// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>

namespace app {

/// How long modules are waited for, in real time. While somebody has asked for a STOP that cannot be
/// fulfilled before the wait is over, that is only a moment. Any thread.
class ModulePatience {
 public:
  using Clock = std::chrono::steady_clock;
  /// The longest time for which a STOP waits for a module.
  static constexpr std::chrono::milliseconds kMoment{100};

  explicit ModulePatience(std::chrono::milliseconds usual) : usual_(usual) {}

  std::chrono::milliseconds usual() const { return usual_; }
  /// A STOP waits.
  void cut() { cutAt_.store(Clock::now().time_since_epoch().count()); }
  /// It was fulfilled.
  void restore() { cutAt_.store(0); }
  /// Whether a wait that began then is over.
  bool isOver(Clock::time_point begin) const {
    const auto now = Clock::now();
    if (now - begin >= usual_) return true;
    const auto cutAt = cutAt_.load();
    return cutAt != 0 && now - std::max(begin, Clock::time_point(Clock::duration(cutAt))) >= kMoment;
  }

 private:
  const std::chrono::milliseconds usual_;
  /// Ticks of the clock; 0: none waits.
  std::atomic<Clock::rep> cutAt_{0};
};

}  // namespace app
