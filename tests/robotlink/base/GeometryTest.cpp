// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/Geometry.h"

#include <gtest/gtest.h>

using namespace robotlink;

TEST(Geometry, aPoseTimesItsInverseIsTheOrigin) {
  const Pose2 pose{1.5, -0.25, radians(130)};
  const Pose2 origin = pose * pose.inverse();
  EXPECT_NEAR(origin.x, 0, 1e-12);
  EXPECT_NEAR(origin.y, 0, 1e-12);
  EXPECT_NEAR(origin.heading, 0, 1e-12);
}

TEST(Geometry, anglesAreNormalizedToAHalfOpenTurn) {
  EXPECT_NEAR(normalizedAngle(3 * kPi), kPi, 1e-12);
  EXPECT_NEAR(normalizedAngle(-kPi), kPi, 1e-12);
  EXPECT_NEAR(normalizedAngle(radians(370)), radians(10), 1e-12);
}

TEST(Geometry, theGroundPoseOfATiltedBodyKeepsItsHeading) {
  Pose3 body = Pose3::Identity();
  body.translate(Vector3(1, 2, 3));
  body.rotate(Eigen::AngleAxisd(0.7, Vector3::UnitZ()) * Eigen::AngleAxisd(0.2, Vector3::UnitY()));
  EXPECT_NEAR(groundPose(body).heading, 0.7, 1e-12);
  EXPECT_NEAR(groundPose(body).y, 2, 1e-12);
}
