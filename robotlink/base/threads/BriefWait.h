// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <thread>

namespace robotlink {

/// Polls a condition for at most `limit` before a thread sleeps: waking a thread costs about 50 us, more
/// than many jobs. Other threads get the processor meanwhile. Returns whether the condition is fulfilled.
template <typename Condition>
bool waitBriefly(std::chrono::microseconds limit, Condition condition) {
  // Most waits are over within the first looks, some 10 us; with more, those who look kept others from
  // working.
  constexpr int kFirstLooks = 200, kLooks = 50;
  const auto begin = std::chrono::steady_clock::now();
  for (int looks = kFirstLooks; true; looks = kLooks) {
    for (int i = 0; i < looks; ++i) {
      if (condition()) return true;
#if defined(__x86_64__)
      __builtin_ia32_pause();
#endif
    }
    if (std::chrono::steady_clock::now() - begin > limit) return false;
    std::this_thread::yield();
  }
}

/// Repeated waits of one thread: it polls a condition before it sleeps, as long as the waits are
/// brief. If they are long, as between the steps of a simulation in real time, it sleeps at once.
class BriefWait {
 public:
  /// For how long it looks.
  explicit BriefWait(std::chrono::microseconds limit) : limit_(limit) {}

  /// Begins a wait. Whether the condition is fulfilled; if not, the thread sleeps until it is.
  template <typename Condition>
  bool look(Condition condition) {
    begin_ = std::chrono::steady_clock::now();
    return areBrief_ && waitBriefly(limit_, condition);
  }
  /// Ends it, when the condition is fulfilled.
  void end() { areBrief_ = std::chrono::steady_clock::now() - begin_ < kLong * limit_; }
  /// Whether the next wait begins with looking.
  bool areBrief() const { return areBrief_; }

 private:
  /// A wait that is this many times longer than the limit is long: waking the thread is a part of it.
  static constexpr int kLong = 3;
  std::chrono::microseconds limit_;
  std::chrono::steady_clock::time_point begin_;
  bool areBrief_ = true;
};

}  // namespace robotlink
