// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/program/Abandoned.h"

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <thread>

namespace app {
namespace {

/// How much was abandoned in the whole process of the operating system, hence a global.
std::atomic<int> abandoned{0};
constexpr std::chrono::milliseconds kAbandonedLook{20};

}  // namespace

void abandon(std::shared_ptr<void> what, std::function<bool()> hasEnded) {
  ++abandoned;
  // No robotlink::PacedThread: this thread has no owner that could join it, and may never end.
  std::thread([what = std::move(what), hasEnded = std::move(hasEnded)]() mutable {
    while (!hasEnded()) std::this_thread::sleep_for(kAbandonedLook);
    hasEnded = nullptr;
    what.reset();
    --abandoned;
  }).detach();
}

int abandonedCount() {
  return abandoned.load();
}

void leave(int status) {
  if (abandonedCount() == 0) return;
  std::cout << std::flush;
  std::cerr << std::flush;
  std::fflush(nullptr);
  std::_Exit(status);
}

}  // namespace app
