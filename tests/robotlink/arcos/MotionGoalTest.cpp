// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/MotionGoal.h"

#include <gtest/gtest.h>

namespace robotlink::arcos {
namespace {

using namespace std::chrono_literals;

const Instant kGoalStart{100s};

RobotState at(const Pose2& pose, Duration after, double speed = 0, double rotation = 0) {
  RobotState state;
  state.pose = pose;
  state.time = kGoalStart + after;
  state.speed = speed;
  state.rotation = rotation;
  state.moving = speed != 0 || rotation != 0;
  return state;
}

TEST(MotionGoal, aRobotThatStandsWhereItWasSentHasArrived) {
  auto goal = MotionGoal::move(at({0, 0, 0}, 0s), kGoalStart, -0.5);
  EXPECT_FALSE(goal.take(at({-0.1, 0, 0}, 500ms, -0.2)));
  EXPECT_FALSE(goal.take(at({-0.49, 0, 0}, 2000ms, -0.05)));
  EXPECT_EQ(goal.take(at({-0.5, 0, 0}, 2500ms)), MotionEnd::kArrived);
}

TEST(MotionGoal, aRobotThatHasNotBegunYetIsNotThere) {
  auto goal = MotionGoal::move(at({0, 0, 0}, 0s), kGoalStart, 1);
  EXPECT_FALSE(goal.take(at({0, 0, 0}, 0ms)));
  EXPECT_FALSE(goal.take(at({0, 0, 0}, 200ms)));
  EXPECT_EQ(goal.take(at({0, 0, 0}, 1000ms)), MotionEnd::kStopped) << "its motors are off";
}

TEST(MotionGoal, whatIsInTheWayStallsIt) {
  auto goal = MotionGoal::move(at({0, 0, 0}, 0s), kGoalStart, 1);
  RobotState state = at({0.3, 0, 0}, 1s, 0.1);
  state.leftStalled = true;
  EXPECT_EQ(goal.take(state), MotionEnd::kStalled);
}

TEST(MotionGoal, theWayCountsNotTheDirection) {
  auto goal = MotionGoal::move(at({5, 5, kPi / 2}, 0s), kGoalStart, 0.6);
  EXPECT_FALSE(goal.take(at({5, 5.3, kPi / 2}, 1s, 0.3)));
  EXPECT_FALSE(goal.take(at({5, 5.3, kPi}, 2s, 0, 0.5)));
  EXPECT_FALSE(goal.take(at({4.7, 5.3, kPi}, 3s, 0.3)));
  EXPECT_EQ(goal.take(at({4.7, 5.3, kPi}, 4s)), MotionEnd::kArrived);
}

TEST(MotionGoal, aTurnEndsAtItsHeadingOverTheWrap) {
  auto goal = MotionGoal::turn(at({0, 0, 3}, 0s), kGoalStart, normalizedAngle(3 + kPi / 2));
  EXPECT_FALSE(goal.take(at({0, 0, -2.5}, 1s, 0, 0.5)));
  EXPECT_EQ(goal.take(at({0, 0, normalizedAngle(3 + kPi / 2)}, 2s)), MotionEnd::kArrived);
}

TEST(MotionGoal, statesFromBeforeTheCommandDoNotCount) {
  auto goal = MotionGoal::move(at({0, 0, 0}, 0s), kGoalStart, 1);
  RobotState before = at({0, 0, 0}, -50ms);
  before.rightStalled = true;
  EXPECT_FALSE(goal.take(before));
}

}  // namespace
}  // namespace robotlink::arcos
