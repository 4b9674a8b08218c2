// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/Simulation.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/simcore/SceneFixture.h"

namespace simcore {
namespace {

using robotlink::Rgb;
using robotlink::Vector3;
using testing::HasSubstr;

class SimulationTest : public testing::Test {
 protected:
  void SetUp() override { start({.seed = 1, .noise = false}); }
  void start(SimulationOptions options) {
    simulation_ = std::move(Simulation::create(shippedScene(), options).value());
  }
  void run(int steps) {
    for (int i = 0; i < steps; ++i) simulation_->step();
  }
  const std::vector<double>& reading(const std::string& path) const {
    const auto sensors = simulation_->sensors();
    const auto found =
        std::ranges::find(sensors, path, [](const Sensor& sensor) { return sensor.info.path; });
    EXPECT_NE(found, sensors.end()) << path;
    return found->values;
  }
  std::size_t servo(const std::string& joint) const {
    const auto servos = simulation_->servos();
    const std::string path = "red1/" + joint + "/request";
    const auto found = std::ranges::find(servos, path, [](const Servo& one) { return one.info.path; });
    EXPECT_NE(found, servos.end()) << joint;
    return static_cast<std::size_t>(found - servos.begin());
  }
  double angle(const std::string& joint) const { return reading("red1/" + joint + "/position")[0]; }
  Vector3 position(const std::string& model) const { return simulation_->modelPose(model)->translation(); }

  std::unique_ptr<Simulation> simulation_;
};

TEST_F(SimulationTest, aRobotStandsStillForTenSeconds) {
  run(250);
  const Vector3 start = position("red1");
  const double neck = angle("neckTilt");
  run(2250);
  EXPECT_LT(std::abs(position("red1").z() - start.z()), 0.002);
  EXPECT_LT((position("red1") - start).norm(), 0.01);
  EXPECT_GT(simulation_->modelPose("red1")->linear()(2, 2), 0.999);
  EXPECT_NEAR(angle("neckTilt"), neck, 0.01);
  for (const char* paw : {"pawFR", "pawFL", "pawHR", "pawHL"})
    EXPECT_EQ(reading(std::string("red1/") + paw)[0], 1) << paw;
}

TEST_F(SimulationTest, timeGoesByFourMillisecondsAStep) {
  run(25);
  EXPECT_EQ(simulation_->steps(), 25U);
  EXPECT_EQ(simulation_->time(), std::chrono::milliseconds(100));
}

TEST_F(SimulationTest, aServoTurnsNoFasterThanItCan) {
  const std::size_t pan = servo("headPan");
  simulation_->requestAngle(pan, 1.2);
  double previous = angle("headPan"), fastest = 0;
  for (int i = 0; i < 200; ++i) {
    run(1);
    fastest = std::max(fastest, (angle("headPan") - previous) / 0.004);
    previous = angle("headPan");
  }
  EXPECT_NEAR(previous, 1.2, 0.01);
  EXPECT_LT(fastest, simulation_->servos()[pan].maximumSpeed * 1.15);
  EXPECT_GT(fastest, simulation_->servos()[pan].maximumSpeed * 0.8);
}

TEST_F(SimulationTest, requestsAreLimitedToTheRangeAndMustBeNumbers) {
  simulation_->requestAngle(servo("headPan"), 100);
  simulation_->requestAngle(servo("neckTilt"), std::numeric_limits<double>::quiet_NaN());
  simulation_->requestAngle(servo("headRoll"), -std::numeric_limits<double>::infinity());
  simulation_->setTorqueLimit(servo("mouth"), std::numeric_limits<double>::quiet_NaN());
  run(300);
  EXPECT_NEAR(angle("headPan"), robotlink::radians(89.6), 0.02);
  EXPECT_NEAR(angle("neckTilt"), 0, 0.02);
  EXPECT_NEAR(angle("headRoll"), robotlink::radians(-29), 0.02);
  EXPECT_TRUE(std::isfinite(position("red1").norm()));
}

TEST_F(SimulationTest, aRobotWhoseServosHaveNoTorqueSinksDown) {
  for (std::size_t i = 0; i < simulation_->servos().size(); ++i) simulation_->setTorqueLimit(i, 0);
  run(500);
  EXPECT_LT(position("red1").z(), 0.08);
  EXPECT_GT(position("red1").z(), 0.02);
}

TEST_F(SimulationTest, jointsStayWithinTheirStops) {
  // Without torque, gravity alone pushes the joints against their stops.
  for (std::size_t i = 0; i < simulation_->servos().size(); ++i) simulation_->setTorqueLimit(i, 0);
  double excess = 0;
  for (int step = 0; step < 500; ++step) {
    run(1);
    for (std::size_t i = 0; i < simulation_->servos().size(); ++i) {
      const Servo& limits = simulation_->servos()[i];
      const double now = simulation_->sensors()[i].values[0];
      excess = std::max({excess, now - limits.maximum, limits.minimum - now});
    }
  }
  EXPECT_LT(excess, robotlink::radians(6));
}

TEST_F(SimulationTest, atRestTheAccelerometerFeelsGravity) {
  run(500);
  Vector3 mean = Vector3::Zero();
  for (int i = 0; i < 100; ++i) {
    run(1);
    const auto& values = reading("red1/accelerometer");
    mean += Vector3(values[0], values[1], values[2]) / 100;
  }
  EXPECT_LT((mean - Vector3(0, 0, 9.81)).norm(), 0.3);
}

TEST_F(SimulationTest, aBallThatIsPutElsewhereIsNotFeltByTheRobot) {
  const auto feltWhileItSinks = [this](bool ballIsMoved) {
    start({.seed = 1, .noise = false});
    for (std::size_t i = 0; i < simulation_->servos().size(); ++i) simulation_->setTorqueLimit(i, 0);
    run(40);
    if (ballIsMoved) {
      EXPECT_TRUE(simulation_->placeModel("ball", {1.5, 1, 0}));
    }
    run(1);
    return reading("red1/accelerometer");
  };
  const auto undisturbed = feltWhileItSinks(false), felt = feltWhileItSinks(true);
  for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(felt[axis], undisturbed[axis], 0.5) << axis;
}

TEST_F(SimulationTest, theDistanceSensorSeesTheGroundAndTheBall) {
  // The sensor looks along the head 16 mm above its middle: tilted down, at the ground some way ahead.
  simulation_->requestAngle(servo("neckTilt"), robotlink::radians(-40));
  run(400);
  const double ground = reading("red1/psd")[0];
  EXPECT_GT(ground, 0.2);
  EXPECT_LT(ground, 0.45);
  const Pose3 head = simulation_->bodyPoses()[static_cast<std::size_t>(simulation_->cameras()[0].body)];
  const Vector3 hit = head * (Vector3(0.0265, 0, 0.0162) + ground * Vector3::UnitX());
  EXPECT_NEAR(hit.z(), 0, 0.001);
  ASSERT_TRUE(simulation_->placeModel("ball", {hit.x() - 0.03, hit.y(), 0}));
  EXPECT_LT(reading("red1/psd")[0], ground - 0.02);
}

TEST_F(SimulationTest, aDistanceSensorThatSeesNothingGivesItsRange) {
  simulation_->requestAngle(servo("neckTilt"), robotlink::radians(30));
  run(300);
  EXPECT_EQ(reading("red1/psd")[0], 0.9);
}

TEST_F(SimulationTest, noiseHasTheSizeThatTheModelGives) {
  start({.seed = 3, .noise = true});
  std::vector<double> errors;
  for (int i = 0; i < 500; ++i) {
    run(1);
    errors.push_back(angle("tailPan"));
  }
  double sum = 0, squares = 0;
  for (const double error : errors) sum += error, squares += error * error;
  const double mean = sum / 500, sigma = std::sqrt(squares / 500 - mean * mean);
  EXPECT_NEAR(sigma, 0.002, 0.0003);
}

TEST_F(SimulationTest, readingASensorTwiceGivesTheSame) {
  start({.seed = 3, .noise = true});
  run(10);
  const auto first = reading("red1/accelerometer");
  EXPECT_EQ(reading("red1/accelerometer"), first);
}

TEST_F(SimulationTest, aDraggedRobotStandsWhereItWasPut) {
  run(100);
  const double height = position("red1").z();
  ASSERT_TRUE(simulation_->placeModel("red1", {0.5, -0.6, 2.0}));
  const robotlink::Pose2 placed = robotlink::groundPose(*simulation_->modelPose("red1"));
  EXPECT_NEAR(placed.x, 0.5, 1e-9);
  EXPECT_NEAR(placed.y, -0.6, 1e-9);
  EXPECT_NEAR(placed.heading, 2.0, 1e-9);
  EXPECT_NEAR(position("red1").z(), height, 1e-9);
  run(500);
  EXPECT_LT((position("red1") - Vector3(0.5, -0.6, height)).norm(), 0.01);
}

TEST_F(SimulationTest, aRobotIsPutOnItsSideAndFalls) {
  run(100);
  const double height = position("red1").z();
  ASSERT_TRUE(simulation_->placeModel("red1", {0.5, -0.6, 2.0},
                                      ModelPosture{.height = height + 0.2, .roll = robotlink::radians(90)}));
  const Pose3 placed = *simulation_->modelPose("red1");
  EXPECT_LT((placed.translation() - Vector3(0.5, -0.6, height + 0.2)).norm(), 1e-9);
  EXPECT_NEAR(placed.linear()(2, 2), 0, 1e-9) << "its back is to the side";
  EXPECT_NEAR(placed.linear()(2, 1), 1, 1e-9) << "its left side is up";
  EXPECT_NEAR(robotlink::groundPose(placed).heading, 2.0, 1e-9);
  run(500);
  EXPECT_LT(position("red1").z(), height + 0.1);
  // Without a posture it is moved as it lies.
  const double tilt = simulation_->modelPose("red1")->linear()(2, 2);
  ASSERT_TRUE(simulation_->placeModel("red1", {-0.5, 0.6, 0}));
  EXPECT_NEAR(simulation_->modelPose("red1")->linear()(2, 2), tilt, 1e-9);
  EXPECT_FALSE(simulation_->placeModel(
      "red1", {}, ModelPosture{.roll = std::numeric_limits<double>::quiet_NaN(), .pitch = 0}));
}

TEST_F(SimulationTest, aPlaceWhereAModelDoesNotFitIsRefused) {
  const Vector3 ball = position("ball");
  const auto inRobot = simulation_->placeModel("ball", {-0.7275, 0.066, 0});
  ASSERT_FALSE(inRobot);
  EXPECT_THAT(inRobot.error().text, HasSubstr("'red1' is in the way"));
  const auto inWall = simulation_->placeModel("red1", {0, 1.35, 0});
  ASSERT_FALSE(inWall);
  EXPECT_THAT(inWall.error().text, HasSubstr("'field' is in the way"));
  EXPECT_FALSE(simulation_->placeModel("field", {}));
  EXPECT_FALSE(simulation_->placeModel("nobody", {}));
  EXPECT_FALSE(simulation_->placeModel("ball", {std::numeric_limits<double>::quiet_NaN(), 0, 0}));
  EXPECT_FALSE(simulation_->placeModel("ball", {1e9, 0, 0}));
  EXPECT_LT((position("ball") - ball).norm(), 1e-9);
  EXPECT_FALSE(simulation_->modelPose("nobody"));
}

TEST_F(SimulationTest, aBallThatDoesNotFitElsewhereRollsOn) {
  const auto speedAfter = [this](bool refused) {
    start({.seed = 1, .noise = false});
    // A fore leg swings forward and pushes it away.
    EXPECT_TRUE(simulation_->placeModel("ball", {-0.8 + 0.0725 + 0.06, 0.066, 0}));
    simulation_->requestAngle(servo("legFL1"), robotlink::radians(60));
    simulation_->requestAngle(servo("legFL3"), robotlink::radians(20));
    run(100);
    const Vector3 before = position("ball");
    if (refused) {
      EXPECT_FALSE(simulation_->placeModel("ball", {0, 1.35, 0}));
    }
    EXPECT_LT((position("ball") - before).norm(), 1e-12);
    run(10);
    return (position("ball") - before).norm() / 0.04;
  };
  const double undisturbed = speedAfter(false);
  EXPECT_GT(undisturbed, 0.02) << "it rolls";
  EXPECT_NEAR(speedAfter(true), undisturbed, 1e-6);
}

TEST_F(SimulationTest, aTouchOfTheBallCountsWhenItBegins) {
  EXPECT_EQ(simulation_->ballContacts(), 0U);
  run(100);
  EXPECT_EQ(simulation_->ballContacts(), 0U);
  // Right before the chest; the fore legs swing forward into it.
  ASSERT_TRUE(simulation_->placeModel("ball", {-0.8 + 0.0725 + 0.06, 0.066, 0}));
  simulation_->requestAngle(servo("legFL1"), robotlink::radians(40));
  simulation_->requestAngle(servo("legFL3"), robotlink::radians(60));
  run(250);
  EXPECT_GE(simulation_->ballContacts(), 1U);
  EXPECT_LE(simulation_->ballContacts(), 5U);
  EXPECT_GT((position("ball") - position("red1")).norm(), 0.2) << "the ball was pushed away";
  simulation_->reset(1);
  EXPECT_EQ(simulation_->ballContacts(), 0U);
}

TEST_F(SimulationTest, aRollingBallComesToRest) {
  // A fore leg swings forward and pushes it away.
  ASSERT_TRUE(simulation_->placeModel("ball", {-0.8 + 0.0725 + 0.06, 0.066, 0}));
  simulation_->requestAngle(servo("legFL1"), robotlink::radians(60));
  simulation_->requestAngle(servo("legFL3"), robotlink::radians(20));
  run(125);
  simulation_->requestAngle(servo("legFL1"), robotlink::radians(-35));
  run(2500);
  const Vector3 place = position("ball");
  run(250);
  EXPECT_LT((position("ball") - place).norm(), 0.01);
  EXPECT_GT((place - Vector3(-0.667, 0.066, 0.042)).norm(), 0.05);
}

TEST_F(SimulationTest, theBallLiesStillAndTheRenderSceneShowsIt) {
  run(250);
  EXPECT_LT(position("ball").head<2>().norm(), 0.001);
  EXPECT_NEAR(position("ball").z(), 0.042, 0.001);
  const auto scene = simulation_->renderScene();
  ASSERT_EQ(scene->bodies.size(), simulation_->bodyPoses().size());
  EXPECT_EQ(scene->bodies[0], "world");
  const auto ball = std::ranges::find(scene->instances, "ball/ball/ball", &RenderInstance::name);
  ASSERT_NE(ball, scene->instances.end());
  EXPECT_EQ(ball->color, (Rgb{255, 105, 0}));
  EXPECT_LT((simulation_->bodyPoses()[static_cast<std::size_t>(ball->body)].translation() - position("ball"))
                .norm(),
            1e-12);
}

TEST_F(SimulationTest, servosTellTheTorqueWithWhichTheyHold) {
  run(500);
  const std::size_t tilt = servo("neckTilt");
  const double maximum = simulation_->servos()[tilt].maximumTorque;
  // The head's weight pulls it down in front of the neck.
  EXPECT_GT(std::abs(simulation_->servoTorque(tilt)), 0.01 * maximum);
  EXPECT_LE(std::abs(simulation_->servoTorque(tilt)), maximum * 1.001);
  // Limp joints that are not at a stop exert none.
  simulation_->setTorqueLimit(tilt, 0);
  run(2);
  EXPECT_NEAR(simulation_->servoTorque(tilt), 0, 0.001 * maximum);
}

}  // namespace
}  // namespace simcore
