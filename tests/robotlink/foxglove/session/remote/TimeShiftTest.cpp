// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/session/remote/TimeShift.h"

#include <gtest/gtest.h>

namespace robotlink::websocket {
namespace {

using namespace std::chrono_literals;

Instant secondsAt(double s) {
  return Instant(fromSeconds(s));
}

TEST(TimeShift, whatLeadsKeepsItsTimesAlsoAfterAReset) {
  TimeShift shift;
  EXPECT_EQ(shift.map(secondsAt(1000), {}), secondsAt(1000));
  EXPECT_EQ(shift.map(secondsAt(999.9), {}), secondsAt(999.9));
  shift.reset();
  EXPECT_EQ(shift.map(secondsAt(0), {}), secondsAt(0));
  EXPECT_EQ(shift.newest(), secondsAt(0));
}

TEST(TimeShift, whatFollowsBeginsAtTheLeadingTimeAndKeepsItsDistances) {
  TimeShift shift;
  EXPECT_EQ(shift.map(secondsAt(1e6), secondsAt(5)), secondsAt(5));
  EXPECT_EQ(shift.map(secondsAt(1e6 + 0.25), secondsAt(5.1)), secondsAt(5.25));
  EXPECT_EQ(shift.map(secondsAt(1e6 + 0.125), secondsAt(5.1)), secondsAt(5.125));
}

TEST(TimeShift, aClockThatRunsAwayOrStandsStillIsBroughtBack) {
  TimeShift shift;
  shift.map(secondsAt(100), secondsAt(5));
  // An hour ahead all at once.
  EXPECT_EQ(shift.map(secondsAt(3700), secondsAt(6)), secondsAt(6));
  // Far behind, as after a pause.
  EXPECT_EQ(shift.map(secondsAt(3701), secondsAt(60)), secondsAt(60));
  // Set back.
  shift.reset();
  EXPECT_EQ(shift.map(secondsAt(1), secondsAt(61)), secondsAt(61));
}

TEST(TimeShift, itNeverGoesBackWhileItFollows) {
  TimeShift shift;
  shift.map(secondsAt(100), secondsAt(50));
  shift.map(secondsAt(100.4), secondsAt(50));
  // What leads stands still, and even goes back a little.
  Instant before = *shift.newest();
  for (int i = 1; i < 100; ++i) {
    const Instant now = shift.map(secondsAt(100.4 + i), secondsAt(49.9));
    EXPECT_GE(now, before);
    EXPECT_LE(now, secondsAt(50.5));
    before = now;
  }
}

TEST(TimeShift, aRobotThatWasStartedAnewContinuesAfterTheGap) {
  TimeShift shift;
  shift.map(secondsAt(300), {});
  shift.continueAfter(20s);
  EXPECT_EQ(shift.map(secondsAt(0.5), {}), secondsAt(320));
  EXPECT_EQ(shift.map(secondsAt(1.5), {}), secondsAt(321));
}

TEST(TimeShift, latchedMessagesAreNotNewerThanOthersAndMoveNothing) {
  TimeShift shift;
  EXPECT_EQ(shift.mapLatched(secondsAt(763), {}), secondsAt(763));
  EXPECT_FALSE(shift.hasTime());
  EXPECT_EQ(shift.map(secondsAt(14), {}), secondsAt(14));
  EXPECT_TRUE(shift.hasTime());
  EXPECT_EQ(shift.mapLatched(secondsAt(763), {}), secondsAt(14));
  EXPECT_EQ(shift.mapLatched(secondsAt(5), {}), secondsAt(5));
  EXPECT_EQ(shift.map(secondsAt(15), {}), secondsAt(15));
  shift.continueAfter(20s);
  EXPECT_EQ(shift.mapLatched(secondsAt(0.5), {}), secondsAt(15));
  EXPECT_EQ(shift.map(secondsAt(0.5), {}), secondsAt(35));
}

TEST(TimeShift, absurdTimesDoNotOverflow) {
  TimeShift shift;
  EXPECT_LE(shift.mapLatched(Instant::max(), Instant::max()), Instant(24h * 365 * 101));
  EXPECT_LE(shift.map(Instant::max(), Instant::max()), Instant(24h * 365 * 101));
  EXPECT_GE(shift.map(Instant::min(), secondsAt(0)), secondsAt(0));
}

TEST(TimeShift, aRobotThatIsStartedAgainAndAgainWithAClockOfItsOwnDoesNotOverflow) {
  TimeShift shift;
  Instant before;
  for (int i = 0; i < 10; ++i) {
    shift.continueAfter(i % 2 == 0 ? Duration::max() : Duration::min());
    for (const Instant remote : {Instant(), Instant::max()}) {
      const Instant now = shift.map(remote, {});
      EXPECT_GE(now, before);
      EXPECT_LE(now, Instant(24h * 365 * 101));
      before = now;
    }
  }
}

}  // namespace
}  // namespace robotlink::websocket
