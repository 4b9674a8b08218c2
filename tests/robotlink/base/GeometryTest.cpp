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

TEST(Geometry, theZAxisIsTurnedToADirectionByTheShortestRotation) {
  for (const Vector3& direction : {Vector3(0, 0, 2), Vector3(1, 2, 3), Vector3(-3, 1, -0.5), Vector3(0, 1, 0),
                                   Vector3(1e-5, 0, -1), Vector3(0, 0, -4)}) {
    const Eigen::Matrix3d rotation = rotationFromZAxis(direction);
    EXPECT_TRUE((rotation * Vector3::UnitZ()).isApprox(direction.normalized(), 1e-9))
        << direction.transpose();
    EXPECT_TRUE((rotation * rotation.transpose()).isIdentity(1e-12));
    EXPECT_NEAR(rotation.determinant(), 1, 1e-9);
    EXPECT_NEAR(Eigen::AngleAxisd(rotation).angle(), std::acos(direction.normalized().z()), 1e-6);
  }
}

TEST(Geometry, theGroundPoseOfATiltedBodyKeepsItsHeading) {
  Pose3 body = Pose3::Identity();
  body.translate(Vector3(1, 2, 3));
  body.rotate(Eigen::AngleAxisd(0.7, Vector3::UnitZ()) * Eigen::AngleAxisd(0.2, Vector3::UnitY()));
  EXPECT_NEAR(groundPose(body).heading, 0.7, 1e-12);
  EXPECT_NEAR(groundPose(body).y, 2, 1e-12);
}
