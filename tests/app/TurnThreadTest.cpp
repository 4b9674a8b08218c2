// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/program/TurnThread.h"

#include <gtest/gtest.h>

#include <atomic>

#include "tests/Eventually.h"

namespace app {
namespace {

using namespace std::chrono_literals;

TEST(TurnThread, whoAsksForATurnGetsItsResultAtOnce) {
  int turns = 0;
  TurnThread thread([&] { ++turns; });
  for (int i = 1; i <= 100; ++i) {
    EXPECT_TRUE(thread.run(30s));
    EXPECT_EQ(turns, i);
    EXPECT_FALSE(thread.isBusy());
  }
}

TEST(TurnThread, aTurnThatDoesNotReturnKeepsNobody) {
  std::atomic<bool> isReleased{false};
  TurnThread thread([&] { isReleased.wait(false); });
  EXPECT_FALSE(thread.run(1ms));
  EXPECT_TRUE(thread.isBusy());
  EXPECT_FALSE(thread.waitFor(1ms));
  isReleased = true;
  isReleased.notify_all();
  EXPECT_TRUE(thread.waitFor(30s));
  EXPECT_TRUE(thread.run(30s));
}

}  // namespace
}  // namespace app
