// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/game/FieldOfPlay.h"

#include <gtest/gtest.h>

#include "robotlink/config/FieldDescription.h"

namespace app {
namespace {

using robotlink::Vector2;
using robotlink::Vector3;

/// 4 m by 3 m with goals of 0.8 m, 0.3 m deep and 0.4 m high, and a ball of 4 cm.
robotlink::FieldDescription field(bool hasBoundary) {
  robotlink::FieldDescription result;
  result.length = hasBoundary ? 5 : 4;
  result.width = hasBoundary ? 4 : 3;
  if (hasBoundary) {
    result.boundaryLength = 4;
    result.boundaryWidth = 3;
  }
  result.wallThickness = 0.1;
  result.goalWidth = 0.8;
  result.goalDepth = 0.3;
  result.goalHeight = 0.4;
  result.goals = {{"blue", 2, ""}, {"yellow", -2, ""}};
  result.penaltyAreaLength = 0.6;
  result.penaltyAreaWidth = 1.4;
  result.ballRadius = 0.04;
  return result;
}

TEST(FieldOfPlay, theWholeBallMustBeInTheGoal) {
  struct Case {
    const char* what;
    Vector3 ball;
    int side;
  };
  const Case cases[] = {
      {"in the middle", {0, 0, 0.04}, 0},        {"on the line", {2.03, 0, 0.04}, 0},
      {"behind the line", {2.05, 0, 0.04}, 1},   {"in the other goal", {-2.05, 0.3, 0.04}, -1},
      {"beside the goal", {2.05, 0.5, 0.04}, 0}, {"above the goal", {2.05, 0, 0.5}, 0},
      {"behind the goal", {2.5, 0, 0.04}, 0},
  };
  for (const bool hasBoundary : {false, true})
    for (const Case& one : cases) EXPECT_EQ(goalWithBall(field(hasBoundary), one.ball), one.side) << one.what;
}

TEST(FieldOfPlay, aBallIsOutWhenAllOfItIs) {
  EXPECT_TRUE(isBallOnField(field(true), {0, 1.53, 0}));
  EXPECT_FALSE(isBallOnField(field(true), {0, -1.55, 0}));
  EXPECT_FALSE(isBallOnField(field(true), {2.05, 0, 0}));
  // On a wall it still is on the field.
  EXPECT_TRUE(isBallOnField(field(false), {0, 1.58, 0}));
  EXPECT_FALSE(isBallOnField(field(false), {0, 1.62, 0}));
}

TEST(FieldOfPlay, robotsMayStandInGoalsAndALittleOutside) {
  EXPECT_TRUE(isRobotOnField(field(true), {1.9, 1.4}, 0));
  EXPECT_FALSE(isRobotOnField(field(true), {2.1, 1}, 0));
  EXPECT_TRUE(isRobotOnField(field(true), {2.1, 1}, 0.2));
  EXPECT_TRUE(isRobotOnField(field(true), {-2.2, 0.3}, 0));
  EXPECT_FALSE(isRobotOnField(field(true), {-2.4, 0.3}, 0));
  EXPECT_FALSE(isRobotOnField(field(true), {0, 1.6}, 0));
  EXPECT_TRUE(isRobotOnField(field(true), {0, -1.6}, 0.2));
}

TEST(FieldOfPlay, eachSideHasItsPenaltyArea) {
  EXPECT_TRUE(isInPenaltyArea(field(true), {1.5, 0.6}, 1));
  EXPECT_FALSE(isInPenaltyArea(field(true), {1.5, 0.6}, -1));
  EXPECT_TRUE(isInPenaltyArea(field(true), {-1.5, -0.6}, -1));
  EXPECT_FALSE(isInPenaltyArea(field(true), {1.3, 0}, 1));
  EXPECT_FALSE(isInPenaltyArea(field(true), {1.5, 0.8}, 1));
}

TEST(FieldOfPlay, theNearestPointInsideIsInside) {
  EXPECT_EQ(nearestInside(field(true), {9, -9}, 0.5), Vector2(1.5, -1));
  EXPECT_EQ(nearestInside(field(true), {0.25, 0.5}, 0.5), Vector2(0.25, 0.5));
  // More than half the field: its middle is left.
  EXPECT_EQ(nearestInside(field(true), {1, 1}, 10), Vector2(0, 0));
}

}  // namespace
}  // namespace app
