// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/behavior/BallSkills.h"

#include <gtest/gtest.h>

namespace modules {
namespace {

using robotlink::Vector2;
using Robots = std::vector<Vector2>;

class BallSkillsTest : public testing::Test {
 protected:
  /// The direction in which it walks toward a near place, rad.
  double directionTo(const Vector2& place, const Robots& robots) {
    const Intention walk = skills_.walkTo(place, 0, robots);
    return std::atan2(walk.left, walk.forward);
  }
  /// Near enough for walking in any direction.
  const Vector2 ahead_{0.34, 0};
  BallSkills skills_{{}};
};

TEST_F(BallSkillsTest, whatIsNotInTheWayChangesNothing) {
  EXPECT_NEAR(directionTo(ahead_, {}), 0, 1e-9);
  EXPECT_NEAR(directionTo(ahead_, {{-0.35, 0}}), 0, 1e-9) << "behind it";
  EXPECT_NEAR(directionTo(ahead_, {{0.5, 0}}), 0, 1e-9) << "beyond the place";
  EXPECT_NEAR(directionTo(ahead_, {{0.1, 0.4}}), 0, 1e-9) << "beside the way";
}

TEST_F(BallSkillsTest, aRobotIsPassedOnTheNearerSide) {
  EXPECT_LT(directionTo(ahead_, {{0.4, 0.1}}), -0.3);
  directionTo(ahead_, {});
  EXPECT_GT(directionTo(ahead_, {{0.4, -0.1}}), 0.3);
  directionTo(ahead_, {});
  EXPECT_LT(directionTo(ahead_, {{0.42, 0}}), -0.3) << "on the right if it is met head-on";
}

TEST_F(BallSkillsTest, theSideOnWhichARobotIsPassedIsKept) {
  EXPECT_LT(directionTo(ahead_, {{0.4, 0.03}}), -0.3);
  EXPECT_LT(directionTo(ahead_, {{0.4, -0.03}}), -0.3) << "although it seems to stand on the other side now";
  EXPECT_GT(directionTo(ahead_, {{0.4, -0.15}}), 0.3) << "unless the other side is much nearer";
  EXPECT_GT(directionTo(ahead_, {{0.4, -0.03}}), 0.3);
  directionTo(ahead_, {});
  EXPECT_LT(directionTo(ahead_, {{0.4, 0.03}}), -0.3) << "a free way makes it forget";
}

TEST_F(BallSkillsTest, theLastWayToTheBallIsSlowAtThePaws) {
  const BallSkills::Options& o = skills_.options();
  const Vector2 still(0, 0);
  const Intention far = skills_.position({o.kickX + 0.25, 0}, still, 0, KickKind::kAhead);
  const Intention near = skills_.position({o.kickX + 0.05, 0}, still, 0, KickKind::kAhead);
  EXPECT_NEAR(far.forward, o.forwardSpeed, 1e-9);
  EXPECT_LE(near.forward, o.positionSpeed + 1e-9);
  EXPECT_GT(near.forward, 0);
  const Intention beside = skills_.position({o.kickX + 0.05, 0.08}, still, 0, KickKind::kAhead);
  EXPECT_LT(beside.forward, 0.5 * near.forward) << "sideways first, so that no paw pushes the ball away";
  EXPECT_GT(beside.left, 0.05);
}

TEST_F(BallSkillsTest, aBallThatRollsIsFollowed) {
  const Vector2 there(skills_.options().kickX, 0);
  EXPECT_NEAR(skills_.position(there, {0, 0.06}, 0, KickKind::kAhead).left, 0.06, 1e-9);
  EXPECT_LT(skills_.position(there, {-0.05, 0}, 0, KickKind::kAhead).forward, -0.04);
}

TEST_F(BallSkillsTest, robotsSideBySideArePassedTogether) {
  // The gap between them is narrower than a robot: the left end of both is the nearer one.
  const double turn = directionTo(ahead_, {{0.36, -0.24}, {0.36, 0.1}});
  EXPECT_GT(std::abs(turn), 0.9);
  for (const Vector2& robot : Robots{{0.36, -0.24}, {0.36, 0.1}}) {
    const Vector2 way(std::cos(turn), std::sin(turn));
    const double beside = std::abs(way.x() * robot.y() - way.y() * robot.x());
    EXPECT_GE(beside, BallSkills::Options().robotRadius - 1e-6);
  }
}

TEST_F(BallSkillsTest, nearTheBallItGetsCloserToOthersThatPlayIt) {
  // The place behind the ball is straight ahead, and an opponent stands beside the way there.
  const Vector2 ball{0.57, 0};
  const Robots beside{{0.2, 0.22}};
  const Intention alone = skills_.approach(ball, 0, {}), pressed = skills_.approach(ball, 0, beside);
  EXPECT_NEAR(pressed.left, alone.left, 1e-9);
  EXPECT_LT(skills_.walkTo({0.3, 0}, 0, beside).left, -0.01) << "elsewhere it keeps away";
}

TEST_F(BallSkillsTest, itMakesWayForAMateWithoutTurningAbout) {
  const Vector2 ball{0.2, 0.02}, beyond{1, 0.3};
  const Intention alone = skills_.makeWay(beyond, ball, {});
  EXPECT_EQ(alone.turn, 0);
  EXPECT_GT(std::hypot(alone.forward, alone.left), 0.05);
  EXPECT_LE(alone.forward * ball.x() + alone.left * ball.y(), 1e-9) << "not through the ball";
  // The mate is on its left, and another robot behind it.
  const Vector2 mate{0.02, 0.15};
  const Intention between = skills_.makeWay(beyond, ball, {mate, {-0.3, -0.1}});
  EXPECT_LT(between.left, -0.01);
  EXPECT_LE(between.forward * mate.x() + between.left * mate.y(), 1e-9) << "nor through the mate";
}

TEST_F(BallSkillsTest, theWayBehindTheBallTakesLongestFromItsFront) {
  const double behind = skills_.secondsTo({0.4, 0}, 0), front = skills_.secondsTo({0.4, 0}, robotlink::kPi);
  EXPECT_LT(behind, 1);
  EXPECT_GT(front, 5) << "around half a circle";
  EXPECT_LT(skills_.secondsTo({0.4, 0}, 0.5 * robotlink::kPi), front);
  EXPECT_GT(skills_.secondsTo({2, 0}, 0), 8) << "2 m at its speed";
}

}  // namespace
}  // namespace modules
