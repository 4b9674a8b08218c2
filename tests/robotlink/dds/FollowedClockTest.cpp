// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/dds/FollowedClock.h"

#include <gtest/gtest.h>

#include "tests/Eventually.h"
#include "tests/robotlink/dds/TestNodes.h"

namespace robotlink::test {
namespace {

using namespace std::chrono_literals;

TEST(FollowedClockTest, theAnnouncementThatWasFastestCounts) {
  dds::FollowedClock clock;
  EXPECT_FALSE(clock.isSet());
  EXPECT_LT(clock.now(), Instant(20s));
  clock.note(1, Instant(100s), 0s);
  EXPECT_TRUE(clock.isSet());
  EXPECT_GE(clock.now(), Instant(100s));
  // It was under way for half a second longer.
  clock.note(1, Instant(100s), 500ms);
  EXPECT_GE(clock.now(), Instant(100s));
  clock.note(1, Instant(200s), 100ms);
  EXPECT_GE(clock.now(), Instant(199s));
}

TEST(FollowedClockTest, aProgramThatWasStartedAgainSetsItBack) {
  dds::FollowedClock clock;
  clock.note(1, Instant(1000s), 0s);
  EXPECT_GE(clock.now(), Instant(1000s));
  clock.note(2, Instant(1s), 0s);
  EXPECT_LT(clock.now(), Instant(900s));
  EXPECT_GE(clock.now(), Instant(1s));
}

TEST(FollowedClockTest, itNeverGoesBackOtherwise) {
  dds::FollowedClock clock;
  for (int i = 0; i < 200; ++i) {
    const Instant before = clock.now();
    clock.note(1, Instant(100s - i * 1ms), 0s);
    if (i > 0) {
      EXPECT_GE(clock.now(), before);
    }
  }
}

TEST(FollowedClockTest, programsShowTheTimeOfTheOneWithThePlatform) {
  const auto here = openTestNode();
  const auto there = openTestNode();
  ASSERT_TRUE(here && there);
  ManualClock platform;
  platform.set(Instant(5000s));
  dds::FollowedClock clock;
  ASSERT_TRUE(clock.follow(there, "robot"));
  const auto source = dds::ClockSource::open(here, "robot", platform);
  ASSERT_TRUE(source);
  EXPECT_TRUE(eventually([&] { return clock.now() >= Instant(5000s); }));
}

}  // namespace
}  // namespace robotlink::test
