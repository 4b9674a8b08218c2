// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/body/LineBudget.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace app {
namespace {

using robotlink::fromSeconds;
using namespace std::chrono_literals;

TEST(LineBudget, aLineWithoutAQueueHasNone) {
  LineBudget budget;
  for (int i = 0; i < 20; ++i) budget.measured(200ms + i * 2ms, 250'000);
  EXPECT_EQ(budget.bytesPerSecond(), 0);
}

/// A line of 125 kB/s with 0.2 s of round trip, over which 250 kB/s could be sent.
TEST(LineBudget, findsWhatALineCarriesWithoutAQueue) {
  constexpr double kLine = 125'000, kWanted = 250'000, kStep = 2, kBuffer = 0.5;
  LineBudget budget;
  budget.measured(200ms, 1'000);
  double queue = 0, longest = 0, least = kLine;
  for (int i = 0; i < 60; ++i) {
    const double wanted = budget.bytesPerSecond() > 0 ? std::min(budget.bytesPerSecond(), kWanted) : kWanted;
    // What does not fit into the buffer is thinned.
    queue = std::clamp(queue + (wanted - kLine) / kLine * kStep, 0.0, kBuffer);
    const double received = std::min(wanted, kLine);
    budget.measured(200ms + fromSeconds(queue), received);
    if (i < 20) continue;
    longest = std::max(longest, queue);
    least = std::min(least, received);
  }
  EXPECT_LT(longest, 0.3);
  EXPECT_GT(least, 0.6 * kLine);
}

TEST(LineBudget, isGivenUpWhenTheLineIsWideAgain) {
  LineBudget budget;
  budget.measured(10ms, 100'000);
  budget.measured(400ms, 100'000);
  EXPECT_EQ(budget.bytesPerSecond(), 0) << "perhaps the computer was busy";
  budget.measured(400ms, 100'000);
  EXPECT_EQ(budget.bytesPerSecond(), 75'000);
  for (int i = 0; i < 20; ++i) budget.measured(10ms, 75'000);
  EXPECT_EQ(budget.bytesPerSecond(), 0);
}

TEST(LineBudget, leavesRoomForReadings) {
  LineBudget budget;
  budget.measured(10ms, 1000);
  for (int i = 0; i < 20; ++i) budget.measured(900ms, 1000);
  EXPECT_EQ(budget.bytesPerSecond(), LineBudget::kLeast);
}

}  // namespace
}  // namespace app
