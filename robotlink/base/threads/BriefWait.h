// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <thread>

namespace robotlink {

/// Looks for a condition for at most `limit` before a thread sleeps: to wake a thread costs some 50 us, more
/// than many a job. Whoever else wants the processor gets it meanwhile. Returns whether it is fulfilled.
template <typename Condition>
bool waitBriefly(std::chrono::microseconds limit, Condition condition) {
  // Most waits are over within the first looks, some 50 us.
  constexpr int kFirstLooks = 1000, kLooks = 50;
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

}  // namespace robotlink
