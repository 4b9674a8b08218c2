// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/modeling/BallFilter.h"

#include <gtest/gtest.h>

#include "robotlink/base/Random.h"

namespace modules {
namespace {

using robotlink::Pose2;
using robotlink::Vector2;

constexpr double kFrame = 0.04;

TEST(LastBall, keepsTheBallInPlaceWhileTheRobotWalks) {
  LastBall ball({2});
  ball.update(0, {}, BallMeasurement{{1, 0}, 1});
  ball.update(1, {0.4, 0, robotlink::kPi / 2}, {});
  EXPECT_TRUE(ball.estimate().known);
  EXPECT_NEAR(ball.estimate().position.x(), 0, 1e-9);
  EXPECT_NEAR(ball.estimate().position.y(), -0.6, 1e-9);
  EXPECT_DOUBLE_EQ(ball.estimate().secondsSinceSeen, 1);
}

TEST(LastBall, forgetsAfterItsMemory) {
  LastBall ball({2});
  EXPECT_FALSE(ball.estimate().known);
  ball.update(0, {}, BallMeasurement{{1, 0}, 1});
  ball.update(2.1, {}, {});
  EXPECT_FALSE(ball.estimate().known);
}

TEST(BallFilter, isBetterThanItsPercepts) {
  robotlink::Random random(1);
  BallFilter filter({});
  double filtered = 0, raw = 0;
  for (int i = 0; i < 200; ++i) {
    const Vector2 noise{0.06 * random.normal(), 0.06 * random.normal()};
    filter.update(i * kFrame, {}, BallMeasurement{Vector2(1, 0.2) + noise, 1});
    if (i < 50) continue;
    raw += noise.norm();
    filtered += (filter.estimate().position - Vector2(1, 0.2)).norm();
  }
  EXPECT_LT(filtered, 0.5 * raw);
}

TEST(BallFilter, learnsTheVelocityOfARollingBall) {
  BallFilter filter({});
  for (int i = 0; i < 50; ++i) filter.update(i * kFrame, {}, BallMeasurement{{1 - 0.3 * i * kFrame, 0}, 1});
  EXPECT_NEAR(filter.estimate().velocity.x(), -0.3, 0.08);
  EXPECT_NEAR(filter.estimate().velocity.y(), 0, 0.02);
  EXPECT_NEAR(filter.estimate().position.x(), 1 - 0.3 * 49 * kFrame, 0.03);
}

TEST(BallFilter, seesABallAtRestAsResting) {
  BallFilter filter({});
  // The robot turns and walks; the ball stays where it is.
  for (int i = 0; i < 100; ++i) {
    const Pose2 robot{0.1 * i * kFrame, 0, 0.4 * i * kFrame};
    filter.update(i * kFrame, robot, BallMeasurement{robot.inverse() * Vector2(1, 0.3), 1});
  }
  EXPECT_LT(filter.estimate().velocity.norm(), 0.01);
}

TEST(BallFilter, ignoresOneWrongPerceptAndBelievesSeveral) {
  BallFilter filter({});
  for (int i = 0; i < 50; ++i) filter.update(i * kFrame, {}, BallMeasurement{{0.8, 0}, 1});
  filter.update(50 * kFrame, {}, BallMeasurement{{2.5, 1.5}, 1});
  EXPECT_NEAR(filter.estimate().position.x(), 0.8, 0.05);
  for (int i = 51; i < 55; ++i) filter.update(i * kFrame, {}, BallMeasurement{{2.5, 1.5}, 1});
  EXPECT_NEAR(filter.estimate().position.x(), 2.5, 0.1);
  EXPECT_NEAR(filter.estimate().position.y(), 1.5, 0.1);
}

TEST(BallFilter, forgetsAfterItsMemoryAndStartsAnew) {
  BallFilter filter({});
  filter.update(0, {}, BallMeasurement{{1, 0}, 1});
  filter.update(10, {}, {});
  EXPECT_FALSE(filter.estimate().known);
  for (int i = 0; i < 5; ++i) filter.update(10.1 + i * kFrame, {}, BallMeasurement{{0.5, -1}, 1});
  EXPECT_TRUE(filter.estimate().known);
  EXPECT_LT((filter.estimate().position - Vector2(0.5, -1)).norm(), 0.1);
}

}  // namespace
}  // namespace modules
