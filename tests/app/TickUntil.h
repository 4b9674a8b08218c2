// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <thread>

#include "app/core/Workbench.h"

namespace app::test {

/// Ticks the workbench, as its window does, until a condition holds. Returns false if it does not hold within
/// twenty seconds.
template <typename Condition>
bool tickUntil(Workbench& workbench, Condition condition) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (std::chrono::steady_clock::now() < end) {
    workbench.tick();
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

}  // namespace app::test
