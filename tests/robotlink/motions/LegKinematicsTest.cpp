// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/motions/LegKinematics.h"

#include <gtest/gtest.h>

#include "robotlink/base/Random.h"

namespace robotlink {
namespace {

TEST(LegKinematicsTest, theStanceOfTheDrawingIsReached) {
  const LegKinematics kinematics;
  const double radius = kinematics.dimensions().pawRadius;
  // J1 = 0, J2 = 0, J3 = 35 degrees; the ground contacts are those of Sony's drawing.
  const Vector3 fore = kinematics.pawInHip(Leg::kFrontLeft, {0, 0, radians(35)});
  EXPECT_NEAR(fore.x(), 0.0128 + 0.0224, 5e-4);
  EXPECT_NEAR(fore.z() - radius, -0.1289, 5e-4);
  const Vector3 hind = kinematics.pawInHip(Leg::kHindRight, {0, 0, radians(35)});
  EXPECT_NEAR(hind.x(), -0.0128 - 0.0166, 5e-4);
  EXPECT_NEAR(hind.z() - radius, -0.1389, 5e-4);
}

TEST(LegKinematicsTest, positiveAnglesGoAwayFromTheBody) {
  const LegKinematics kinematics;
  for (const Leg leg : kLegs) {
    const Vector3 rest = kinematics.pawInHip(leg, {});
    const double away = isFore(leg) ? 1 : -1, outside = isLeft(leg) ? 1 : -1;
    EXPECT_GT((kinematics.pawInHip(leg, {0.3, 0, 0}) - rest).x() * away, 0.02);
    EXPECT_GT((kinematics.pawInHip(leg, {0, 0.3, 0}) - rest).y() * outside, 0.02);
    EXPECT_GT((kinematics.pawInHip(leg, {0, 0, 0.3}) - rest).x() * away, 0.01);
  }
}

TEST(LegKinematicsTest, theInverseFindsTheAngles) {
  const LegKinematics kinematics;
  Random random(3);
  for (int i = 0; i < 4000; ++i) {
    const Leg leg = kLegs[random.bits() % 4];
    // Knees bent to the body's middle, the paw below the shoulder.
    const LegAngles angles{random.uniform(-1.2, 0.8), random.uniform(-0.02, 1.0), random.uniform(0.65, 2.0)};
    const auto solution = kinematics.anglesFor(leg, kinematics.pawInHip(leg, angles));
    ASSERT_TRUE(solution.reached) << i;
    EXPECT_NEAR(solution.angles.swing, angles.swing, 1e-9);
    EXPECT_NEAR(solution.angles.spread, angles.spread, 1e-9);
    EXPECT_NEAR(solution.angles.knee, angles.knee, 1e-9);
  }
}

TEST(LegKinematicsTest, pointsOutOfReachGiveTheNearestLimits) {
  const LegKinematics kinematics;
  const auto far = kinematics.anglesFor(Leg::kFrontLeft, {0, 0, -0.5});
  EXPECT_FALSE(far.reached);
  EXPECT_NEAR(kinematics.pawInHip(Leg::kFrontLeft, far.angles).norm(), 0.1222, 1e-3);
  const auto inside = kinematics.anglesFor(Leg::kHindLeft, {0, -0.08, -0.08});
  EXPECT_FALSE(inside.reached);
  EXPECT_GE(inside.angles.spread, LegKinematics::minimumSpread(Leg::kHindLeft, inside.angles.swing));
  EXPECT_FALSE(kinematics.anglesFor(Leg::kFrontLeft, {0, 0, 0}).reached);
}

TEST(LegKinematicsTest, theLeastSpreadIsThatOfTheTable) {
  EXPECT_NEAR(degrees(LegKinematics::minimumSpread(Leg::kFrontLeft, 0)), -11, 1e-9);
  EXPECT_NEAR(degrees(LegKinematics::minimumSpread(Leg::kFrontLeft, radians(90))), -0.7, 1e-9);
  EXPECT_NEAR(degrees(LegKinematics::minimumSpread(Leg::kHindLeft, radians(75))), -2.75, 1e-9);
  EXPECT_NEAR(degrees(LegKinematics::minimumSpread(Leg::kHindRight, radians(-200))), 3.0, 1e-9);
  EXPECT_NEAR(degrees(LegKinematics::minimumSpread(Leg::kFrontRight, radians(200))), 2.0, 1e-9);
}

TEST(LegKinematicsTest, hipsAreAtTheCornersOfTheBody) {
  const LegKinematics kinematics;
  EXPECT_EQ(kinematics.hipInBody(Leg::kFrontLeft), Vector3(0.0595, 0.0592, 0));
  EXPECT_EQ(kinematics.hipInBody(Leg::kHindRight), Vector3(-0.0595, -0.0592, 0));
}

}  // namespace
}  // namespace robotlink
