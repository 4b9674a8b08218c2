// SPDX-License-Identifier: GPL-3.0-or-later
// What the Pioneer 3-AT's maker says that it climbs: sills of 9 cm and grades of 45 %.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/simcore/DriveScenes.h"
#include "tests/simcore/truth/TruthTable.h"

namespace simcore::truth {
namespace {

constexpr double kSill = 0.09, kGrade = 0.45, kSpeed = 0.3;

TEST(ClimbingTruth, aPioneerClimbsASillOfNineCentimeters) {
  DrivenWorld world(pioneerAt(kRobot, -0.5, 0) + boxAt("sill", {1.05, 0, kSill / 2}, {0.1, 2, kSill}));
  world.drive(kSpeed, kSpeed, 9);
  const Pose3 pose = *world->modelPose(kRobot);
  constexpr double kBehind = 1.6;
  compare({"P3-AT over a sill of 9 cm, way that it lacks to be behind it",
           "0: its maker says that it climbs it", 0, 0.001, "m"},
          std::max(0.0, kBehind - pose.translation().x()));
  compare({"P3-AT over a sill of 9 cm, heading behind it", "0", 0, 0.05, "rad"},
          robotlink::groundPose(pose).heading);
}

TEST(ClimbingTruth, aPioneerClimbsAGradeOfFortyFivePercent) {
  const double slope = std::atan(kGrade);
  const Vector3 middle(1 + 2.5 * std::cos(slope) + 0.05 * std::sin(slope), 0,
                       2.5 * std::sin(slope) - 0.05 * std::cos(slope));
  DrivenWorld world(pioneerAt(kRobot, 0, 0) + boxAt("ramp", middle, {5, 3, 0.1}, -slope));
  world.drive(kSpeed, kSpeed, 7);
  const Vector3 before = world->modelPose(kRobot)->translation();
  world.drive(kSpeed, kSpeed, 2);
  const Pose3 pose = *world->modelPose(kRobot);
  compare({"P3-AT on a grade of 45 %, speed uphill", "that of its wheels; its maker: it climbs 45 %", kSpeed,
           0.05, "m/s"},
          (pose.translation() - before).norm() / 2);
  compare({"P3-AT on a grade of 45 %, slope on which it drives", "atan(0.45)", slope, 0.03, "rad"},
          std::asin(pose.linear()(2, 0)));
}

}  // namespace
}  // namespace simcore::truth
