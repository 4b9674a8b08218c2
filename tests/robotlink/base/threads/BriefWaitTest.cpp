// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/threads/BriefWait.h"

#include <gtest/gtest.h>

namespace robotlink {
namespace {

using namespace std::chrono_literals;

TEST(BriefWait, looksWhileWaitsAreBrief) {
  BriefWait wait(1h);
  int looks = 0;
  for (int round = 1; round <= 3; ++round) {
    EXPECT_TRUE(wait.look([&] { return ++looks == 5 * round; }));
    wait.end();
    EXPECT_EQ(looks, 5 * round);
  }
}

TEST(BriefWait, sleepsAtOnceAfterALongWait) {
  // Every wait is longer than no time.
  BriefWait wait(0us);
  wait.look([] { return true; });
  wait.end();
  int looks = 0;
  EXPECT_FALSE(wait.look([&] { return ++looks > 0; }));
  EXPECT_EQ(looks, 0);
}

TEST(BriefWait, givesUpLookingAfterItsLimit) {
  BriefWait wait(1us);
  EXPECT_FALSE(wait.look([] { return false; }));
}

}  // namespace
}  // namespace robotlink
