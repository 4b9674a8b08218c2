// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/behavior/KickPlanner.h"

#include <gtest/gtest.h>

#include "robotlink/config/FieldDescription.h"

namespace modules {
namespace {

class KickPlannerTest : public testing::Test {
 protected:
  TeamPlaces places_{
      *robotlink::FieldDescription::load(ROBOTCONTROL_SOURCE_DIR "/resources/fields/2002.yaml"), {}};
  KickPlanner planner_{places_, {}};
};

TEST_F(KickPlannerTest, aRobotBehindTheBallKicksAheadIntoTheGoal) {
  const auto choice = planner_.choose({{1.2, 0, 0}, {1.6, 0}, {}});
  EXPECT_EQ(choice.side, KickSide::kAhead);
  EXPECT_NEAR(choice.direction, 0, 0.2);
}

TEST_F(KickPlannerTest, aBallAcrossTheWayIsKickedToTheSide) {
  // It looks to the left wall, and the goal is to its right.
  const auto choice = planner_.choose({{1.6, -0.3, robotlink::kPi / 2}, {1.6, 0}, {}});
  EXPECT_EQ(choice.side, KickSide::kRight);
  EXPECT_NEAR(robotlink::normalizedAngle(choice.direction), 0, 0.5);
}

TEST_F(KickPlannerTest, aBallAtTheWallHasRoomForAKickAwayFromIt) {
  const auto choice = planner_.choose({{0, 1, robotlink::kPi / 2}, {0, 1.3}, {}});
  EXPECT_NE(choice.side, KickSide::kAhead) << "straight ahead there is only the wall";
  EXPECT_LT(robotlink::normalizedAngle(choice.direction), 0.2);
}

TEST_F(KickPlannerTest, thereIsNoRoomBetweenBallAndWall) {
  EXPECT_FALSE(planner_.secondsToGoal({{0, 0, 0}, {0, 1.3}, {}}, {KickSide::kAhead, -1.5}));
  EXPECT_TRUE(planner_.secondsToGoal({{0, 0, 0}, {0, 0}, {}}, {KickSide::kAhead, -1.5}));
}

TEST_F(KickPlannerTest, theOwnGoalIsTheLastChoice) {
  const KickPlanner::Situation now{{-1.4, 0, robotlink::kPi}, {-1.7, 0}, {}};
  EXPECT_GT(*planner_.secondsToGoal(now, {KickSide::kAhead, robotlink::kPi}), 50);
  EXPECT_GT(std::cos(planner_.choose(now).direction), -0.5);
}

TEST_F(KickPlannerTest, aBallStopsAtRobots) {
  const KickPlanner::Choice ahead{KickSide::kAhead, 0};
  const KickPlanner::Situation free{{0.3, 0, 0}, {0.6, 0}, {}};
  KickPlanner::Situation blocked = free;
  blocked.opponents = {{0.8, 0.02}};
  EXPECT_GT(*planner_.secondsToGoal(blocked, ahead), *planner_.secondsToGoal(free, ahead) + 2);
  KickPlanner::Situation byMate = free;
  byMate.mates = {{0.8, 0.02}};
  EXPECT_GT(*planner_.secondsToGoal(byMate, ahead), *planner_.secondsToGoal(free, ahead) + 2);
  KickPlanner::Situation beside = free;
  beside.opponents = {{0.6, 0.3}};
  EXPECT_NEAR(*planner_.secondsToGoal(beside, ahead), *planner_.secondsToGoal(free, ahead), 1e-9);
  EXPECT_GT(std::abs(robotlink::normalizedAngle(planner_.choose(blocked).direction)), 0.2)
      << "it is played past the opponent";
}

TEST_F(KickPlannerTest, aStoppedBallCostsWhatTheOptionsSay) {
  const KickPlanner::Choice ahead{KickSide::kAhead, 0};
  const KickPlanner::Situation blocked{{0.3, 0, 0}, {0.6, 0}, {{0.75, 0}}};
  const double before = *planner_.secondsToGoal(blocked, ahead);
  planner_.setOptions({.stoppedSeconds = 5});
  EXPECT_NEAR(*planner_.secondsToGoal(blocked, ahead), before + 5, 1e-9);
  const KickPlanner::Situation free{{0.3, 0, 0}, {0.6, 0}, {}};
  EXPECT_LT(*planner_.secondsToGoal(free, ahead), before);
}

TEST_F(KickPlannerTest, anOpponentBehindTheBallIsInTheWay) {
  const KickPlanner::Choice ahead{KickSide::kAhead, 0};
  const KickPlanner::Situation free{{0.3, 0, 0}, {0.6, 0}, {}};
  KickPlanner::Situation occupied = free;
  occupied.opponents = {{0.35, 0}};
  EXPECT_NEAR(*planner_.secondsToGoal(occupied, ahead) - *planner_.secondsToGoal(free, ahead), 3, 0.01);
}

TEST_F(KickPlannerTest, keepsItsChoiceWhileTheBallIsAtThePaws) {
  const auto first = planner_.choose({{1.2, 0, 0}, {1.6, 0}, {}});
  const KickPlanner::Situation elsewhere{{1.6, -0.3, robotlink::kPi / 2}, {1.6, 0}, {}};
  EXPECT_EQ(planner_.choose(elsewhere, true).side, first.side);
  EXPECT_NE(KickPlanner(places_, {}).choose(elsewhere).side, first.side);
}

}  // namespace
}  // namespace modules
