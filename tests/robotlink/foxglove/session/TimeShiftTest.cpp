// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/session/TimeShift.h"

#include <gtest/gtest.h>

namespace robotlink::websocket {
namespace {

using namespace std::chrono_literals;

Instant at(double s) {
  return Instant(fromSeconds(s));
}

TEST(TimeShift, whatLeadsKeepsItsTimesAlsoAfterAReset) {
  TimeShift shift;
  EXPECT_EQ(shift.map(at(1000), {}), at(1000));
  EXPECT_EQ(shift.map(at(999.9), {}), at(999.9));
  shift.reset();
  EXPECT_EQ(shift.map(at(0), {}), at(0));
  EXPECT_EQ(shift.newest(), at(0));
}

TEST(TimeShift, whatFollowsBeginsAtTheLeadingTimeAndKeepsItsDistances) {
  TimeShift shift;
  EXPECT_EQ(shift.map(at(1e6), at(5)), at(5));
  EXPECT_EQ(shift.map(at(1e6 + 0.25), at(5.1)), at(5.25));
  EXPECT_EQ(shift.map(at(1e6 + 0.125), at(5.1)), at(5.125));
}

TEST(TimeShift, aClockThatRunsAwayOrStandsStillIsBroughtBack) {
  TimeShift shift;
  shift.map(at(100), at(5));
  // An hour ahead all at once.
  EXPECT_EQ(shift.map(at(3700), at(6)), at(6));
  // Far behind, as after a pause.
  EXPECT_EQ(shift.map(at(3701), at(60)), at(60));
  // Set back.
  shift.reset();
  EXPECT_EQ(shift.map(at(1), at(61)), at(61));
}

TEST(TimeShift, itNeverGoesBackWhileItFollows) {
  TimeShift shift;
  shift.map(at(100), at(50));
  shift.map(at(100.4), at(50));
  // What leads stands still, and even goes back a little.
  Instant before = *shift.newest();
  for (int i = 1; i < 100; ++i) {
    const Instant now = shift.map(at(100.4 + i), at(49.9));
    EXPECT_GE(now, before);
    EXPECT_LE(now, at(50.5));
    before = now;
  }
}

TEST(TimeShift, aRobotThatWasStartedAnewContinuesAfterTheGap) {
  TimeShift shift;
  shift.map(at(300), {});
  shift.continueAfter(20s);
  EXPECT_EQ(shift.map(at(0.5), {}), at(320));
  EXPECT_EQ(shift.map(at(1.5), {}), at(321));
}

TEST(TimeShift, absurdTimesDoNotOverflow) {
  TimeShift shift;
  EXPECT_LE(shift.map(Instant::max(), Instant::max()), Instant(24h * 365 * 101));
  EXPECT_GE(shift.map(Instant::min(), at(0)), at(0));
}

}  // namespace
}  // namespace robotlink::websocket
