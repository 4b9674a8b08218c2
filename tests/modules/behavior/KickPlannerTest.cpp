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
  EXPECT_EQ(choice.kind, KickKind::kAhead);
  EXPECT_NEAR(choice.direction, 0, 0.2);
}

TEST_F(KickPlannerTest, aBallAcrossTheWayIsKickedToTheSide) {
  // It looks to the left wall, and the goal is to its right.
  const auto choice = planner_.choose({{1.6, -0.3, robotlink::kPi / 2}, {1.6, 0}, {}});
  EXPECT_EQ(choice.kind, KickKind::kRight);
  EXPECT_NEAR(robotlink::normalizedAngle(choice.direction), 0, 0.5);
}

TEST_F(KickPlannerTest, aBallAtTheWallHasRoomForAKickAwayFromIt) {
  const auto choice = planner_.choose({{0, 1, robotlink::kPi / 2}, {0, 1.3}, {}});
  EXPECT_NE(choice.kind, KickKind::kAhead) << "straight ahead there is only the wall";
  EXPECT_LT(robotlink::normalizedAngle(choice.direction), 0.2);
}

TEST_F(KickPlannerTest, thereIsNoRoomBetweenBallAndWall) {
  EXPECT_FALSE(planner_.secondsToGoal({{0, 0, 0}, {0, 1.3}, {}}, {KickKind::kAhead, -1.5}));
  EXPECT_TRUE(planner_.secondsToGoal({{0, 0, 0}, {0, 0}, {}}, {KickKind::kAhead, -1.5}));
}

TEST_F(KickPlannerTest, theOwnGoalIsTheLastChoice) {
  const KickPlanner::Situation now{{-1.4, 0, robotlink::kPi}, {-1.7, 0}, {}};
  EXPECT_GT(*planner_.secondsToGoal(now, {KickKind::kAhead, robotlink::kPi}), 50);
  EXPECT_GT(std::cos(planner_.choose(now).direction), -0.5);
}

TEST_F(KickPlannerTest, aBallStopsAtRobots) {
  const KickPlanner::Choice ahead{KickKind::kAhead, 0};
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
  const KickPlanner::Choice ahead{KickKind::kAhead, 0};
  const KickPlanner::Situation blocked{{0.3, 0, 0}, {0.6, 0}, {{0.75, 0}}};
  const double before = *planner_.secondsToGoal(blocked, ahead);
  planner_.setOptions({.stoppedSeconds = 5});
  EXPECT_NEAR(*planner_.secondsToGoal(blocked, ahead), before + 5, 1e-9);
  const KickPlanner::Situation free{{0.3, 0, 0}, {0.6, 0}, {}};
  EXPECT_LT(*planner_.secondsToGoal(free, ahead), before);
}

TEST_F(KickPlannerTest, anOpponentBehindTheBallIsInTheWay) {
  const KickPlanner::Choice ahead{KickKind::kAhead, 0};
  const KickPlanner::Situation free{{0.3, 0, 0}, {0.6, 0}, {}};
  KickPlanner::Situation occupied = free;
  occupied.opponents = {{0.35, 0}};
  EXPECT_NEAR(*planner_.secondsToGoal(occupied, ahead) - *planner_.secondsToGoal(free, ahead), 3, 0.01);
}

TEST_F(KickPlannerTest, theFarKickNeedsTimeAndBringsTheBallFarther) {
  const KickPlanner::Choice far{KickKind::kFarAhead, 0};
  const KickPlanner::Situation alone{{0.1, 0, 0}, {0.4, 0}, {}};
  EXPECT_FALSE(planner_.secondsToGoal(alone, far)) << "without a clearance there is no such kick";
  const double quick = *planner_.secondsToGoal(alone, {KickKind::kAhead, 0});
  planner_.setOptions({.kickLength = 0.7,
                       .kickSpread = 0.2,
                       .farLength = 1.3,
                       .farSpread = 0.2,
                       .farClearance = 0.5,
                       .farSeconds = 0});
  EXPECT_NEAR(*planner_.secondsToGoal(alone, far), quick - 0.6 * KickPlanner::Options().secondsPerMeter, 1);
  EXPECT_EQ(planner_.choose(alone).kind, KickKind::kFarAhead);
  KickPlanner::Situation pressed = alone;
  pressed.opponents = {{0.4, 0.45}};
  EXPECT_FALSE(planner_.secondsToGoal(pressed, far));
  EXPECT_NE(planner_.choose(pressed, true).kind, KickKind::kFarAhead) << "even if it was chosen before";
  KickPlanner::Situation withMate = alone;
  withMate.mates = {{0.4, 0.45}};
  EXPECT_TRUE(planner_.secondsToGoal(withMate, far)) << "mates leave the ball to it";
}

TEST_F(KickPlannerTest, anOpponentAtTheBallMakesThePlayerHasten) {
  // Ahead of it is the touch line; the goal is beside it, half a circle around the ball away.
  const KickPlanner::Situation alone{{0, -0.3, robotlink::kPi / 2}, {0, 0}, {}};
  KickPlanner::Situation pressed = alone;
  pressed.opponents = {{0.2, 0.3}};
  planner_.setOptions({.haste = 3, .hasteDistance = 0.45});
  const KickPlanner::Choice around{KickKind::kAhead, 0};
  const double way = alone.skills.secondsTo({0.3, 0}, -robotlink::kPi / 2);
  EXPECT_NEAR(*planner_.secondsToGoal(pressed, around) - *planner_.secondsToGoal(alone, around), 2 * way,
              0.01);
}

TEST_F(KickPlannerTest, keepsItsChoiceWhileTheBallIsAtThePaws) {
  const auto first = planner_.choose({{1.2, 0, 0}, {1.6, 0}, {}});
  const KickPlanner::Situation elsewhere{{1.6, -0.3, robotlink::kPi / 2}, {1.6, 0}, {}};
  EXPECT_EQ(planner_.choose(elsewhere, true).kind, first.kind);
  EXPECT_NE(KickPlanner(places_, {}).choose(elsewhere).kind, first.kind);
}

}  // namespace
}  // namespace modules
