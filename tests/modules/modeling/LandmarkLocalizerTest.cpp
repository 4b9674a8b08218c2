// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/modeling/LandmarkLocalizer.h"

#include <gtest/gtest.h>

#include <array>

namespace modules {
namespace {

using robotlink::Pose2;
using robotlink::Vector2;

constexpr std::array<std::array<double, 2>, 6> kBeacons{
    {{-2.2, 1.45}, {-2.2, -1.45}, {0, 1.45}, {0, -1.45}, {2.2, 1.45}, {2.2, -1.45}}};

/// Beacons within a view of 100 degrees, with the errors that images have.
std::vector<LandmarkMeasurement> seenFrom(const Pose2& robot, robotlink::Random& random) {
  std::vector<LandmarkMeasurement> seen;
  for (const auto& [x, y] : kBeacons) {
    const Vector2 place = robot.inverse() * Vector2(x, y);
    const double bearing = std::atan2(place.y(), place.x());
    if (std::abs(bearing) < robotlink::radians(50))
      seen.push_back(
          {{x, y}, bearing + 0.02 * random.normal(), place.norm() * (1 + 0.1 * random.normal()), 0.8, false});
  }
  return seen;
}

/// The robot walks in a circle; its dead reckoning is a tenth short and turned.
void walk(LandmarkLocalizer& localizer, Pose2& robot, Pose2& odometry, int frames,
          robotlink::Random& random) {
  for (int i = 0; i < frames; ++i) {
    robot = robot * Pose2{0.004, 0, 0.012};
    odometry = odometry * Pose2{0.0036, 0, 0.011};
    localizer.update(odometry, false, seenFrom(robot, random));
  }
}

TEST(LandmarkLocalizer, findsTheRobotFromNowhere) {
  robotlink::Random random(7);
  LandmarkLocalizer localizer({}, {0, 0, 0}, 1.5);
  Pose2 robot{-0.8, 0.3, 0.5}, odometry;
  walk(localizer, robot, odometry, 500, random);
  const PoseEstimate& estimate = localizer.estimate();
  EXPECT_LT((estimate.robotInField.translation() - robot.translation()).norm(), 0.2);
  EXPECT_NEAR(robotlink::normalizedAngle(estimate.robotInField.heading - robot.heading), 0, 0.15);
  EXPECT_LT(estimate.positionDeviation, 0.25);
}

TEST(LandmarkLocalizer, findsARobotAgainThatWasCarriedAway) {
  robotlink::Random random(8);
  LandmarkLocalizer localizer({}, {1, 0.5, 0}, 0.1);
  Pose2 robot{1, 0.5, 0}, odometry;
  walk(localizer, robot, odometry, 100, random);
  robot = {-1.2, -0.6, 2.0};
  walk(localizer, robot, odometry, 700, random);
  EXPECT_LT((localizer.estimate().robotInField.translation() - robot.translation()).norm(), 0.3);
}

TEST(LandmarkLocalizer, followsDeadReckoningAndGrowsUnsureWithoutLandmarks) {
  LandmarkLocalizer localizer({}, {0, 0, 0}, 0.02);
  const double before = localizer.estimate().positionDeviation;
  for (int i = 0; i <= 100; ++i) localizer.update({0.01 * i, 0, 0}, false, {});
  EXPECT_NEAR(localizer.estimate().robotInField.x, 1.0, 0.1);
  EXPECT_GT(localizer.estimate().positionDeviation, before);
}

TEST(LandmarkLocalizer, growsMoreUnsureWhileItIsShaken) {
  LandmarkLocalizer calm({}, {0, 0, 0}, 0.02), shaken({}, {0, 0, 0}, 0.02);
  for (int i = 0; i <= 50; ++i) {
    calm.update({}, false, {});
    shaken.update({}, true, {});
  }
  EXPECT_GT(shaken.estimate().headingDeviation, 3 * calm.estimate().headingDeviation);
}

TEST(LandmarkLocalizer, staysOnTheField) {
  LandmarkLocalizer localizer({}, {2, 1.3, 0}, 0.5);
  for (int i = 0; i <= 100; ++i) localizer.update({0.02 * i, 0, 0}, false, {});
  for (const Pose2& particle : localizer.particles()) {
    EXPECT_LE(std::abs(particle.x), 2.1);
    EXPECT_LE(std::abs(particle.y), 1.35);
  }
}

TEST(LandmarkLocalizer, isTheSameEveryTime) {
  robotlink::Random first(3), second(3);
  LandmarkLocalizer a({}, {}, 1), b({}, {}, 1);
  Pose2 robotA, odometryA, robotB, odometryB;
  walk(a, robotA, odometryA, 50, first);
  walk(b, robotB, odometryB, 50, second);
  EXPECT_EQ(a.estimate().robotInField, b.estimate().robotInField);
}

}  // namespace
}  // namespace modules
