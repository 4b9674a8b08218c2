// SPDX-License-Identifier: GPL-3.0-or-later
// What holds for both filters that tell a rolling ball from a resting one.
#include <gtest/gtest.h>

#include "modules/modeling/ball/ParticleBall.h"
#include "modules/modeling/ball/RollingBallFilter.h"
#include "robotlink/base/Random.h"

namespace modules {
namespace {

using robotlink::Pose2;
using robotlink::Vector2;

constexpr double kBallImage = 0.04;

template <typename Filter>
class BallTracker : public testing::Test {
 protected:
  /// Shows the ball at a place, as seen by a robot at a pose of dead reckoning, with noise.
  void show(const Vector2& ball, const Pose2& robot = {}, double noise = 0.02) {
    const Vector2 off{noise * random_.normal(), noise * random_.normal()};
    filter_.update(time_ += kBallImage, robot, BallMeasurement{robot.inverse() * ball + off, 1});
  }
  void hide(const Pose2& robot = {}) { filter_.update(time_ += kBallImage, robot, {}); }
  Vector2 place(const Pose2& robot = {}) const { return robot * filter_.estimate().position; }

  Filter filter_{{}};
  robotlink::Random random_{1};
  double time_ = 0;
};

using BallTrackers = testing::Types<RollingBallFilter, ParticleBall>;
TYPED_TEST_SUITE(BallTracker, BallTrackers);

TYPED_TEST(BallTracker, knowsNothingBeforeTheFirstPercept) {
  this->hide();
  EXPECT_FALSE(this->filter_.estimate().known);
}

TYPED_TEST(BallTracker, isBetterThanItsPercepts) {
  double filtered = 0;
  for (int i = 0; i < 200; ++i) {
    this->show({1, 0.2}, {}, 0.03);
    if (i >= 50) filtered += (this->place() - Vector2(1, 0.2)).norm() / 150;
  }
  // The mean length of that noise is 0.038.
  EXPECT_LT(filtered, 0.03);
}

TYPED_TEST(BallTracker, seesABallAtRestAsRestingWhileTheRobotWalks) {
  Pose2 robot;
  for (int i = 0; i < 100; ++i) {
    robot = {0.1 * i * kBallImage, 0, 0.4 * i * kBallImage};
    this->show({1, 0.3}, robot);
  }
  EXPECT_LT(this->filter_.estimate().velocity.norm(), 0.1);
  EXPECT_LT((this->place(robot) - Vector2(1, 0.3)).norm(), 0.05);
}

TYPED_TEST(BallTracker, followsAKickedBall) {
  for (int i = 0; i < 50; ++i) this->show({0.4, 0});
  // It slows down as the filters expect.
  double x = 0.4, speed = 0.8, error = 0;
  for (int i = 0; i < 30; ++i) {
    x += speed * kBallImage;
    speed -= 0.3 * kBallImage;
    this->show({x, 0.05});
    if (i >= 15) error += (this->place() - Vector2(x, 0.05)).norm() / 15;
  }
  EXPECT_LT(error, 0.1);
  EXPECT_NEAR(this->filter_.estimate().velocity.x(), speed, 0.25);
  EXPECT_NEAR(this->filter_.estimate().velocity.y(), 0, 0.15);
}

TYPED_TEST(BallTracker, believesSeveralPerceptsElsewhereButNotOne) {
  for (int i = 0; i < 50; ++i) this->show({0.8, 0});
  this->show({2.5, 1.5});
  EXPECT_LT((this->place() - Vector2(0.8, 0)).norm(), 0.15);
  for (int i = 0; i < 12; ++i) this->show({2.5, 1.5});
  EXPECT_LT((this->place() - Vector2(2.5, 1.5)).norm(), 0.2);
}

TYPED_TEST(BallTracker, growsUnsureAndForgetsAfterItsMemory) {
  for (int i = 0; i < 20; ++i) this->show({1, 0});
  const double before = this->filter_.estimate().deviation;
  for (int i = 0; i < 75; ++i) this->hide();
  EXPECT_TRUE(this->filter_.estimate().known);
  EXPECT_NEAR(this->filter_.estimate().secondsSinceSeen, 3, 1e-6);
  EXPECT_GT(this->filter_.estimate().deviation, before);
  for (int i = 0; i < 80; ++i) this->hide();
  EXPECT_FALSE(this->filter_.estimate().known);
  for (int i = 0; i < 5; ++i) this->show({0.5, -1});
  EXPECT_TRUE(this->filter_.estimate().known);
  EXPECT_LT((this->place() - Vector2(0.5, -1)).norm(), 0.1);
}

TYPED_TEST(BallTracker, isTheSameEveryTime) {
  TypeParam other({});
  for (int i = 1; i <= 50; ++i) {
    const BallMeasurement seen{{1 + 0.01 * i, 0.1}, 0.8};
    this->filter_.update(i * kBallImage, {}, seen);
    other.update(i * kBallImage, {}, seen);
  }
  EXPECT_EQ(this->filter_.estimate().position, other.estimate().position);
}

TEST(RollingBallFilter, knowsWhetherTheBallRolls) {
  RollingBallFilter filter({});
  for (int i = 0; i < 50; ++i) filter.update(i * kBallImage, {}, BallMeasurement{{0.5, 0}, 1});
  EXPECT_LT(filter.rolling(), 0.3);
  for (int i = 50; i < 70; ++i)
    filter.update(i * kBallImage, {}, BallMeasurement{{0.5 + (i - 50) * kBallImage * 0.7, 0}, 1});
  EXPECT_GT(filter.rolling(), 0.8);
}

TEST(BallAccuracy, isLowerAlongTheRayThanAcrossIt) {
  const Eigen::Matrix2d covariance = BallAccuracy{}.covariance({0, 2}, 1, {0, 0, robotlink::kPi / 2});
  // The robot looks along y, so a ball to its left lies along -x.
  EXPECT_GT(covariance(0, 0), 2 * covariance(1, 1));
  EXPECT_NEAR(covariance(0, 1), 0, 1e-12);
}

}  // namespace
}  // namespace modules
