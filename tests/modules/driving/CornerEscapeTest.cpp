// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/driving/CornerEscape.h"

#include <gtest/gtest.h>

#include <vector>

namespace modules {
namespace {

using robotlink::Vector2;

/// A robot of 0.6 m by 0.2 m, which needs 0.35 m to the front and 0.37 m to turn, among points, which asks
/// for the same all the time.
class CornerEscapeTest : public testing::Test {
 protected:
  /// A wall across, `ahead` of the robot's center, from `right` to `left`.
  void wall(double ahead, double right = -2, double left = 2) {
    for (double y = right; y <= left; y += 0.05) points.emplace_back(ahead, y);
  }
  void side(double at, double from = -1, double to = 1) {
    for (double x = from; x <= to; x += 0.05) points.emplace_back(x, at);
  }
  DriveVelocity decide(double time) {
    const Clearance clearance({0.3, 0.1}, {0.05, 4}, points);
    const PolarView view(points, 0.15, 3);
    return escape.decide(desired, clearance.limited(desired, {}, 0.25), clearance, view, {}, time);
  }

  std::vector<Vector2> points;
  DriveVelocity desired{0.4, 0};
  CornerEscape escape{{}};
};

TEST_F(CornerEscapeTest, whatIsPossibleIsDoneWhileThereIsAWay) {
  for (double time = 0; time < 3; time += 0.1) {
    const DriveVelocity velocity = decide(time);
    EXPECT_GT(velocity.forward, 0.3);
    EXPECT_FALSE(escape.active());
  }
}

TEST_F(CornerEscapeTest, itIsPatientBeforeItTurns) {
  wall(0.37);
  decide(10);
  decide(10.4);
  EXPECT_FALSE(escape.active());
  decide(10.51);
  EXPECT_TRUE(escape.active());
}

TEST_F(CornerEscapeTest, itTurnsToTheSideWithMoreRoom) {
  wall(0.37);
  side(-0.8);
  decide(0);
  EXPECT_GT(decide(1).rotation, 0);
  EXPECT_EQ(decide(1.1).forward, 0);
  points.clear();
  escape = CornerEscape({});
  wall(0.37);
  side(0.8);
  decide(0);
  EXPECT_LT(decide(1).rotation, 0);
}

TEST_F(CornerEscapeTest, itKeepsToItsSideUntilThereIsAWay) {
  wall(0.37);
  side(-0.8);
  decide(0);
  EXPECT_GT(decide(1).rotation, 0);
  points.clear();
  wall(0.37);
  side(0.8);  // now there is more room to the right
  EXPECT_GT(decide(1.1).rotation, 0);
  points.clear();
  EXPECT_GT(decide(1.2).forward, 0.3);
  EXPECT_FALSE(escape.active());
}

TEST_F(CornerEscapeTest, itTriesTheOtherSideAfterAWhile) {
  wall(0.37);
  side(-0.8);
  decide(0);
  EXPECT_GT(decide(1).rotation, 0);
  EXPECT_GT(decide(12.9).rotation, 0);
  EXPECT_LT(decide(13.2).rotation, 0);
}

TEST_F(CornerEscapeTest, whereItCannotTurnItBacksOut) {
  wall(0.352, -0.2, 0.2);
  side(0.2, -0.4, 0.3);
  side(-0.2, -0.4, 0.3);
  decide(0);
  const DriveVelocity velocity = decide(1);
  EXPECT_TRUE(escape.active());
  EXPECT_LT(velocity.forward, 0);
  EXPECT_NEAR(velocity.forward, -CornerEscape::Options().backingSpeed, 1e-9);
}

TEST_F(CornerEscapeTest, whoAsksForNothingDoesNotEscape) {
  wall(0.37);
  desired = {0, 0};
  for (double time = 0; time < 3; time += 0.1) {
    EXPECT_EQ(decide(time).rotation, 0);
    EXPECT_FALSE(escape.active());
  }
}

TEST_F(CornerEscapeTest, aClockThatGoesBackStartsThePatienceAnew) {
  wall(0.37);
  decide(100);
  decide(1);
  EXPECT_FALSE(escape.active());
  decide(1.4);
  EXPECT_FALSE(escape.active());
  decide(1.6);
  EXPECT_TRUE(escape.active());
}

}  // namespace
}  // namespace modules
