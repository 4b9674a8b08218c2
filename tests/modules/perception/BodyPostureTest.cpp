// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/perception/BodyPosture.h"

#include <gtest/gtest.h>

namespace modules {
namespace {

using robotlink::radians;
using robotlink::Vector3;

/// Angles of the legs with the ground at a height and slope under the body.
std::array<LegAngles, 4> standing(const BodyTilt& tilt) {
  const LegKinematics legs;
  std::array<LegAngles, 4> angles;
  for (const Leg leg : kLegs) {
    const Vector3 hip = legs.hipInBody(leg);
    // Below the hip, moved along the body's z until the paw's sphere touches the ground.
    Vector3 paw = hip + Vector3(0, isLeft(leg) ? 0.005 : -0.005, -0.1);
    for (int i = 0; i < 20; ++i) paw.z() -= (tilt.bodyInRobot() * paw).z() - legs.dimensions().pawRadius;
    const auto solution = legs.anglesFor(leg, paw - hip);
    EXPECT_TRUE(solution.reached);
    angles[index(leg)] = solution.angles;
  }
  return angles;
}

constexpr std::array<bool, 4> kAllDown{true, true, true, true};

TEST(BodyPosture, findsHeightAndSlopeFromFourPaws) {
  const BodyTilt truth{0.115, radians(4), radians(-3)};
  const BodyTilt found = BodyPosture(LegKinematics(), {20, 0, 0}).estimate(standing(truth), kAllDown);
  EXPECT_NEAR(found.height, truth.height, 1e-4);
  EXPECT_NEAR(found.pitch, truth.pitch, 1e-3);
  EXPECT_NEAR(found.roll, truth.roll, 1e-3);
}

TEST(BodyPosture, caresLittleAboutALiftedPaw) {
  const BodyTilt truth{0.115, 0, 0};
  auto angles = standing(truth);
  angles[index(Leg::kFrontLeft)].knee += radians(35);
  angles[index(Leg::kHindRight)].knee += radians(35);
  const BodyTilt found =
      BodyPosture(LegKinematics(), {20, 1, 0}).estimate(angles, {false, true, true, false});
  EXPECT_NEAR(found.height, truth.height, 0.003);
  EXPECT_NEAR(found.pitch, 0, radians(1.5));
  EXPECT_NEAR(found.roll, 0, radians(1.5));
}

TEST(BodyPosture, isLevelInTheStanceOfTheSimulatedRobot) {
  std::array<LegAngles, 4> stance;
  for (const Leg leg : kLegs)
    stance[index(leg)] = {radians(-35), radians(5), radians(isFore(leg) ? 90 : 105)};
  const BodyTilt found = BodyPosture(LegKinematics(), {20, 1, 0}).estimate(stance, kAllDown);
  EXPECT_NEAR(found.height, 0.1136, 0.0005);
  EXPECT_NEAR(found.pitch, 0, radians(0.3));
}

TEST(CameraInBody, isBeforeAndAboveTheNeckAndLooksWhereTheHeadTurns) {
  const RobotDimensions d;
  const auto ahead = cameraInBody(d, {});
  EXPECT_NEAR((ahead.translation() - Vector3(0.1416, 0, 0.098)).norm(), 0, 1e-9);
  EXPECT_LT((cameraInBody(d, {radians(-30), 0, 0}).linear() * Vector3::UnitX()).z(), -0.49);
  EXPECT_NEAR((cameraInBody(d, {0, radians(90), 0}).linear() * Vector3::UnitX()).y(), 1, 1e-9);
  // Rolled to the right ear, the left side of the head is up.
  EXPECT_GT((cameraInBody(d, {0, 0, radians(20)}).linear() * Vector3::UnitY()).z(), 0.3);
}

}  // namespace
}  // namespace modules
