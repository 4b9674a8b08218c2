// SPDX-License-Identifier: GPL-3.0-or-later
// What the Pioneer 3-AT's maker says that it climbs: sills of 9 cm and grades of 45 %.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/simcore/DriveScenes.h"

namespace simcore {
namespace {

std::string sillOf(double height, double length) {
  return boxAt("sill", {1 + length / 2, 0, height / 2}, {length, 2, height});
}

std::string rampOf(double grade) {
  const double slope = std::atan(grade);
  const robotlink::Vector3 middle(1 + 2.5 * std::cos(slope) + 0.05 * std::sin(slope), 0,
                                  2.5 * std::sin(slope) - 0.05 * std::cos(slope));
  return boxAt("ramp", middle, {5, 3, 0.1}, -slope);
}

TEST(Climbing, aSillOfNineCentimetersIsClimbed) {
  for (const double length : {0.04, 0.1}) {
    for (const double speed : {0.3, 0.6}) {
      DrivenWorld world(pioneerAt(kRobot, -0.5, 0) + sillOf(0.09, length));
      world.drive(speed, speed, speed > 0.5 ? 6 : 9);
      const Pose3 pose = *world->modelPose(kRobot);
      EXPECT_GT(pose.translation().x(), 1.6) << length << " m long, at " << speed << " m/s";
      EXPECT_NEAR(pose.translation().z(), 0, 0.01) << "all wheels are behind it";
      EXPECT_NEAR(robotlink::degrees(world.pose().heading), 0, 3) << length << " m long";
    }
  }
}

TEST(Climbing, aSillOfTwentyCentimetersIsNot) {
  DrivenWorld world(pioneerAt(kRobot, 0, 0) + sillOf(0.2, 0.1));
  world.drive(0.3, 0.3, 9);
  EXPECT_LT(world->modelPose(kRobot)->translation().x(), 0.95);
  EXPECT_LT(world->modelPose(kRobot)->translation().z(), 0.05);
}

TEST(Climbing, aGradeOfFortyFivePercentIsClimbed) {
  DrivenWorld world(pioneerAt(kRobot, 0, 0) + rampOf(0.45));
  world.drive(0.3, 0.3, 9);
  const Pose3 pose = *world->modelPose(kRobot);
  EXPECT_GT(pose.translation().z(), 0.4);
  EXPECT_NEAR(std::asin(pose.linear()(2, 0)), std::atan(0.45), 0.03);
}

TEST(Climbing, aGradeOfAHundredPercentIsNot) {
  DrivenWorld world(pioneerAt(kRobot, 0, 0) + rampOf(1));
  world.drive(0.3, 0.3, 9);
  EXPECT_LT(world->modelPose(kRobot)->translation().z(), 0.3);
}

TEST(Climbing, onTheSpotTheSkidDriveTurnsByItsTrack) {
  // The wheels are 0.394 m apart and 0.269 m long: sliding across makes the track 0.588 m.
  DrivenWorld world(pioneerAt(kRobot, 0, 0));
  world.drive(-0.1, 0.1, 2);
  const double before = world.pose().heading;
  world.drive(-0.1, 0.1, 2);
  EXPECT_NEAR(std::remainder(world.pose().heading - before, 2 * robotlink::kPi), 0.4 / 0.588, 0.02);
}

}  // namespace
}  // namespace simcore
