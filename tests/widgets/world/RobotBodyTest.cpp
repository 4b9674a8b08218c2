// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/world/RobotBody.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "foxglove/Scene.pb.h"

namespace widgets {
namespace {

using robotlink::Vector3;

/// A trunk at the model's origin, and a leg that hangs from it by 0.3 m, with a hinge at its upper end.
RobotBody trunkWithLeg() {
  RobotBody body;
  body.parts.assign(2, robotlink::Pose3::Identity());
  RobotBody::Joint hip;
  hip.name = "hip";
  hip.parent = 0;
  hip.child = 1;
  hip.axis = Vector3::UnitY();
  body.joints.push_back(hip);
  auto shapes = std::make_shared<foxglove::SceneUpdate>();
  shapes->add_entities();
  auto& point = *shapes->add_entities()->add_triangles()->add_points();
  point.set_z(-0.3);
  body.shapes = shapes;
  return body;
}

TEST(RobotBodyTest, theLowestPointTouchesTheGround) {
  const auto standing = partsOnGround(trunkWithLeg(), {});
  ASSERT_EQ(standing.size(), 2U);
  EXPECT_NEAR(standing[0].translation().z(), 0.3, 1e-9);
  const double angle = robotlink::kPi / 3;
  const auto bent = partsOnGround(trunkWithLeg(), {{"hip", angle}});
  EXPECT_NEAR(bent[0].translation().z(), 0.3 * std::cos(angle), 1e-9);
  const Vector3 foot = bent[1] * Vector3(0, 0, -0.3);
  EXPECT_NEAR(foot.z(), 0, 1e-9);
  EXPECT_NEAR(foot.x(), -0.3 * std::sin(angle), 1e-9);
}

TEST(RobotBodyTest, anglesThatAreNotKnownAreTheUsualOnes) {
  RobotBody body = trunkWithLeg();
  body.joints[0].usual = robotlink::kPi / 3;
  const double height = 0.3 * std::cos(robotlink::kPi / 3);
  EXPECT_NEAR(partsOnGround(body, {})[0].translation().z(), height, 1e-9);
  EXPECT_NEAR(partsOnGround(body, {{"hip", std::nan("")}, {"knee", 1}})[0].translation().z(), height, 1e-9);
  EXPECT_NEAR(partsOnGround(body, {{"hip", 0}})[0].translation().z(), 0.3, 1e-9);
}

TEST(RobotBodyTest, jointsOfPartsThatDoNotExistDoNoHarm) {
  RobotBody body = trunkWithLeg();
  body.joints[0].child = 7;
  EXPECT_EQ(partsOnGround(body, {}).size(), 2U);
  body.joints[0] = {"hip", 9, 1};
  EXPECT_EQ(partsOnGround(body, {}).size(), 2U);
  body.shapes.reset();
  EXPECT_EQ(partsOnGround(body, {})[0].translation().z(), 0);
}

}  // namespace
}  // namespace widgets
