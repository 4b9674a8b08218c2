// SPDX-License-Identifier: GPL-3.0-or-later
// The model of the Pioneer 3-AT against its description.
#include <gtest/gtest.h>

#include <algorithm>

#include "robotlink/config/RobotDescription.h"
#include "simcore/Scene.h"
#include "simcore/SceneContents.h"
#include "simcore/Simulation.h"

namespace simcore {
namespace {

std::shared_ptr<const Scene> pioneerScene() {
  static const auto kScene = Scene::load(ROBOTCONTROL_SOURCE_DIR "/resources/scenes/pioneer.sdf");
  EXPECT_TRUE(kScene) << describe(kScene.error());
  return kScene ? *kScene : nullptr;
}

robotlink::RobotDescription pioneerDescription() {
  return robotlink::readRobotDescription(ROBOTCONTROL_SOURCE_DIR "/resources/robots/p3at.yaml").value();
}

const ModelDescription& pioneerModel() {
  const auto& models = pioneerScene()->contents().world.models;
  return *std::ranges::find(models, "p3at1", &ModelInstance::name)->type;
}

const VisualDescription& visual(const std::string& name) {
  const auto& visuals = pioneerModel().links.front().visuals;
  const auto found = std::ranges::find(visuals, name, &VisualDescription::name);
  EXPECT_NE(found, visuals.end()) << name;
  return *found;
}

/// Half of the model's extent along an axis, of all solids; they are boxes, and cylinders about y.
double halfExtent(int axis) {
  double most = 0;
  for (const LinkDescription& link : pioneerModel().links) {
    for (const CollisionDescription& solid : link.collisions) {
      const Pose3 pose = link.poseInModel * solid.poseInLink;
      const Shape& shape = solid.shape;
      const bool box = shape.kind == Shape::Kind::kBox;
      const Vector3 size = box ? shape.size : Vector3(2 * shape.radius, 2 * shape.radius, shape.length);
      const double reach = (pose.linear().cwiseAbs() * size / 2)[axis];
      most = std::max(most, std::abs(pose.translation()[axis]) + reach);
    }
  }
  return most;
}

TEST(PioneerModel, itIsTheDescribedRobot) {
  ASSERT_EQ(pioneerScene()->robots().size(), 1U);
  EXPECT_EQ(pioneerScene()->robots()[0].name, "p3at1");
  EXPECT_EQ(pioneerScene()->robots()[0].description, "p3at");
  const auto drive = *pioneerDescription().drive;
  ASSERT_TRUE(pioneerModel().drive);
  EXPECT_NEAR(pioneerModel().drive->track, drive.track, 1e-9);
  EXPECT_NEAR(pioneerModel().drive->wheelRadius, drive.wheelRadius, 1e-9);
  EXPECT_GE(pioneerModel().drive->maximumSpeed, drive.maximumSpeed);
  EXPECT_GE(pioneerModel().drive->maximumSpeed, drive.maximumRotation * drive.track / 2);
}

TEST(PioneerModel, itIsAsLongAndAsWide) {
  const auto drive = *pioneerDescription().drive;
  EXPECT_NEAR(2 * halfExtent(0), drive.length, 0.002);
  EXPECT_NEAR(2 * halfExtent(1), drive.width, 0.002);
  EXPECT_LT(std::hypot(halfExtent(0), halfExtent(1)), drive.radius);
}

TEST(PioneerModel, massesSumUpToRobotAndLaser) {
  double sum = 0;
  for (const LinkDescription& link : pioneerModel().links) sum += link.mass;
  EXPECT_NEAR(sum, 12 + 4.5, 0.01);
}

TEST(PioneerModel, sonarsAreDrawnWhereTheyAre) {
  const auto sonars = pioneerDescription().sonars->sensors;
  ASSERT_EQ(sonars.size(), 16U);
  for (std::size_t i = 0; i < sonars.size(); ++i) {
    const Pose3& disc = visual("sonar" + std::to_string(i)).poseInLink;
    EXPECT_NEAR(disc.translation().x(), sonars[i].inRobot.x, 1e-4) << i;
    EXPECT_NEAR(disc.translation().y(), sonars[i].inRobot.y, 1e-4) << i;
    const Vector3 axis = disc.linear().col(2);
    EXPECT_NEAR(robotlink::normalizedAngle(std::atan2(axis.y(), axis.x()) - sonars[i].inRobot.heading), 0,
                1e-4)
        << i;
  }
}

TEST(PioneerModel, theDriveIsAPortAndWheelsAreNoSensors) {
  const auto simulation = std::move(Simulation::create(pioneerScene(), {}).value());
  ASSERT_EQ(simulation->drives().size(), 1U);
  EXPECT_EQ(simulation->drives()[0].info.path, "p3at1/drive");
  EXPECT_EQ(simulation->drives()[0].info.robot, "p3at1");
  EXPECT_NEAR(simulation->drives()[0].track, 0.588, 1e-9);
  EXPECT_NEAR(simulation->drives()[0].wheelRadius, 0.111, 1e-9);
  EXPECT_TRUE(simulation->servos().empty());
  const auto count = [&](const std::string& type) {
    return std::ranges::count(simulation->sensors(), type,
                              [](const Sensor& sensor) { return sensor.info.type; });
  };
  EXPECT_EQ(count("contact"), 10);
  EXPECT_EQ(count("angular_velocity"), 1);
  EXPECT_EQ(count("angle"), 0);
}

TEST(PioneerModel, drawnWheelsTurnAsTheyRoll) {
  const auto simulation = std::move(Simulation::create(pioneerScene(), {.seed = 1, .noise = false}).value());
  const auto& bodies = simulation->renderScene()->bodies;
  const auto wheel = [&](const char* name) {
    const auto found = std::ranges::find(bodies, std::string("p3at1/") + name);
    EXPECT_NE(found, bodies.end()) << name;
    return simulation->modelPose("p3at1")->inverse() *
           simulation->bodyPoses()[static_cast<std::size_t>(found - bodies.begin())];
  };
  EXPECT_LT((wheel("wheelFL").translation() - Vector3(0.1345, 0.197, 0.111)).norm(), 1e-4);
  simulation->requestWheelSpeeds(0, 0.111, -0.111);
  for (int i = 0; i < 125; ++i) simulation->step();
  // Half a radian forwards on the left: what was on top of the wheel went to the front.
  const double left = simulation->wheelState(0).leftTravel / 0.111;
  EXPECT_NEAR(left, 0.5, 0.05);
  EXPECT_NEAR(wheel("wheelFL").linear()(0, 2), std::sin(left), 0.01);
  EXPECT_NEAR(wheel("wheelRR").linear()(0, 2), -std::sin(left), 0.02);
  EXPECT_LT((wheel("wheelFL").translation() - Vector3(0.1345, 0.197, 0.111)).norm(), 1e-4);
}

}  // namespace
}  // namespace simcore
