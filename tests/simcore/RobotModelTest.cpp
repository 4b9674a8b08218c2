// SPDX-License-Identifier: GPL-3.0-or-later
// The model of the ERS-210 against its description and against the kinematics that its comment promises.
#include <gmock/gmock.h>

#include <algorithm>

#include "robotlink/config/FieldDescription.h"
#include "robotlink/config/RobotDescription.h"
#include "simcore/ModelParts.h"
#include "simcore/SceneContents.h"
#include "simcore/Simulation.h"
#include "tests/simcore/SceneFixture.h"

namespace simcore {
namespace {

using testing::ElementsAreArray;

const char* const kDescription = ROBOTCONTROL_SOURCE_DIR "/resources/robots/ers210.yaml";

robotlink::RobotDescription description() {
  return robotlink::readRobotDescription(kDescription).value();
}

std::unique_ptr<Simulation> robotSimulation() {
  return std::move(Simulation::create(shippedScene(), {.seed = 1, .noise = false}).value());
}

/// Where the render scene has a body.
Pose3 bodyPose(const Simulation& simulation, const std::string& name) {
  const auto& bodies = simulation.renderScene()->bodies;
  const auto found = std::ranges::find(bodies, name);
  EXPECT_NE(found, bodies.end()) << name;
  return simulation.bodyPoses()[static_cast<std::size_t>(found - bodies.begin())];
}

TEST(RobotModel, servosAreTheDescribedJointsInTheirOrder) {
  const auto robot = description();
  const auto simulated = robotSimulation();
  ASSERT_EQ(simulated->servos().size(), 20U);
  ASSERT_EQ(robot.joints.size(), 20U);
  for (std::size_t i = 0; i < 20; ++i) {
    const Servo& servo = simulated->servos()[i];
    const auto& joint = robot.joints[i];
    EXPECT_EQ(servo.info.path, "red1/" + joint.name + "/request");
    EXPECT_EQ(simulated->sensors()[i].info.path, "red1/" + joint.name + "/position");
    EXPECT_NEAR(servo.minimum, joint.minimum, 1e-4) << joint.name;
    EXPECT_NEAR(servo.maximum, joint.maximum, 1e-4) << joint.name;
    EXPECT_NEAR(servo.maximumSpeed, joint.maximumSpeed, 1e-6) << joint.name;
    EXPECT_NEAR(simulated->sensors()[i].values[0], joint.stance, 1e-4) << joint.name;
  }
}

TEST(RobotModel, partsAndJointsAreKnownWithoutASimulation) {
  const Rgb team{1, 2, 3};
  const auto parts = ModelParts::load("ers210", team);
  ASSERT_TRUE(parts);
  ASSERT_EQ(parts->shapes->bodies.size(), parts->links.size() + 1);
  for (const auto& joint : description().joints) {
    const auto found = std::ranges::find(parts->joints, joint.name, &ModelParts::Joint::name);
    ASSERT_NE(found, parts->joints.end()) << joint.name;
    EXPECT_NEAR(found->usual, joint.stance, 1e-4) << joint.name;
  }
  EXPECT_TRUE(std::ranges::any_of(parts->shapes->instances,
                                  [&](const RenderInstance& instance) { return instance.color == team; }));
}

TEST(RobotModel, whatIsNoRobotHasNoParts) {
  const auto unknown = ModelParts::load("nobody", std::nullopt);
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().front().id, "scene.unknown-model");
  const auto ball = ModelParts::load("ball", std::nullopt);
  ASSERT_FALSE(ball);
  EXPECT_EQ(ball.error().front().id, "scene.no-robot");
}

TEST(RobotModel, massesSumUpToThatOfTheRobot) {
  double sum = 0;
  for (const ModelInstance& model : shippedScene()->contents().world.models) {
    if (model.name != "red1") continue;
    for (const LinkDescription& link : model.type->links) sum += link.mass;
  }
  EXPECT_NEAR(sum, 1.63, 0.01);
}

TEST(BallModel, theBallIsThatOfTheField) {
  const auto field =
      robotlink::FieldDescription::load(ROBOTCONTROL_SOURCE_DIR "/resources/fields/2002.yaml").value();
  const auto& models = shippedScene()->contents().world.models;
  const auto ball =
      std::ranges::find_if(models, [](const ModelInstance& model) { return model.type->isBall; });
  ASSERT_NE(ball, models.end());
  const LinkDescription& link = ball->type->links.front();
  EXPECT_EQ(link.mass, field.ballMass);
  EXPECT_EQ(link.collisions.front().shape.radius, field.ballRadius);
  EXPECT_EQ(link.visuals.front().shape.radius, field.ballRadius);
  EXPECT_EQ(link.visuals.front().color, *field.color(field.ballColor));
  const double moment = 2.0 / 3 * field.ballMass * field.ballRadius * field.ballRadius;
  EXPECT_NEAR(link.inertia(0, 0), moment, moment * 0.001);
}

/// The formula in the model's comment.
Vector3 pawInBody(bool fore, bool left, double q1, double q2, double q3) {
  const double f = fore ? 1 : -1, s = left ? 1 : -1;
  const Vector3 paw = fore ? Vector3(-0.01171, 0, -0.05577) : Vector3(-0.02218, 0, -0.06064);
  const auto ry = [](double angle) { return Eigen::AngleAxisd(angle, Vector3::UnitY()).toRotationMatrix(); };
  const Eigen::Matrix3d rx = Eigen::AngleAxisd(s * q2, Vector3::UnitX()).toRotationMatrix();
  const Vector3 knee(f * 0.0128, 0, -0.064);
  return Vector3(f * 0.0595, s * 0.0592, 0) +
         ry(-f * q1) * rx * (knee + ry(-f * q3) * Vector3(f * paw.x(), 0, paw.z()));
}

TEST(RobotModel, pawsAreWhereTheDocumentedKinematicsHasThem) {
  const auto robot = description();
  const auto simulated = robotSimulation();
  const Pose3 body = *simulated->modelPose("red1");
  for (const char* leg : {"FR", "FL", "HR", "HL"}) {
    const bool fore = leg[0] == 'F', left = leg[1] == 'L';
    const auto angle = [&](char number) {
      const int joint = robot.jointIndex(std::string("leg") + leg + number);
      return robot.joints[static_cast<std::size_t>(joint)].stance;
    };
    const Vector3 expected = pawInBody(fore, left, angle('1'), angle('2'), angle('3'));
    const double f = fore ? 1 : -1;
    const Vector3 pawInLeg = fore ? Vector3(f * -0.01171, 0, -0.05577) : Vector3(f * -0.02218, 0, -0.06064);
    const Vector3 paw =
        body.inverse() * (bodyPose(*simulated, std::string("red1/lowerLeg") + leg) * pawInLeg);
    EXPECT_LT((paw - expected).norm(), 1e-5) << leg;
  }
}

TEST(RobotModel, theStanceIsSymmetricAndJustTouchesTheGround) {
  const auto robot = description();
  const auto stance = [&](const std::string& name) {
    return robot.joints[static_cast<std::size_t>(robot.jointIndex(name))].stance;
  };
  const auto height = [&](bool fore, const std::string& leg) {
    return pawInBody(fore, true, stance(leg + "1"), stance(leg + "2"), stance(leg + "3")).z();
  };
  EXPECT_NEAR(height(true, "legFL"), height(false, "legHL"), 0.0005);
  const double lowest = std::min(height(true, "legFL"), height(false, "legHL"));
  const double clearance = robotSimulation()->modelPose("red1")->translation().z() + lowest - 0.0125;
  EXPECT_GE(clearance, 0);
  EXPECT_LT(clearance, 0.0005);
}

TEST(RobotModel, theCameraLooksFromWhereTheDataSheetHasIt) {
  const auto simulated = robotSimulation();
  ASSERT_EQ(simulated->cameras().size(), 1U);
  const CameraSensor& camera = simulated->cameras()[0];
  EXPECT_EQ(camera.info.path, "red1/camera/image");
  EXPECT_THAT(camera.info.shape, ElementsAreArray({144, 176, 3}));
  EXPECT_NEAR(robotlink::degrees(camera.model.horizontalAngle), 57.6, 1e-3);
  EXPECT_NEAR(robotlink::degrees(camera.model.verticalAngle), 47.8, 1e-3);
  EXPECT_EQ(camera.period, std::chrono::milliseconds(40));
  const Pose3 cameraInWorld =
      simulated->bodyPoses()[static_cast<std::size_t>(camera.body)] * camera.cameraInBody;
  const Vector3 inBody = simulated->modelPose("red1")->inverse() * cameraInWorld.translation();
  EXPECT_LT((inBody - Vector3(0.075 + 0.0666, 0, 0.050 + 0.048)).norm(), 1e-6);
}

TEST(RobotModel, positiveAnglesTurnTheHeadUpAndToTheLeft) {
  const auto simulated = robotSimulation();
  simulated->requestAngle(0, 0.4);
  simulated->requestAngle(1, 0.7);
  for (int i = 0; i < 250; ++i) simulated->step();
  const CameraSensor& camera = simulated->cameras()[0];
  const Vector3 view =
      (simulated->bodyPoses()[static_cast<std::size_t>(camera.body)] * camera.cameraInBody).linear().col(0);
  EXPECT_NEAR(std::asin(view.z()), 0.4 * std::cos(0.7), 0.1);
  EXPECT_NEAR(std::atan2(view.y(), view.x()), 0.7, 0.1);
}

}  // namespace
}  // namespace simcore
