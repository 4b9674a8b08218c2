// SPDX-License-Identifier: GPL-3.0-or-later
// Vehicles whose wheels roll by forces: a car with a steering axle, a robot on mecanum wheels, and one on two
// wheels and casters.
#include <gtest/gtest.h>

#include <cmath>

#include "simcore/Scene.h"
#include "tests/simcore/moving/MovingScenes.h"

namespace simcore {
namespace {

using robotlink::Pose2;

/// The radius of the circle on which a model's origin moves, from its speed and its turning rate.
double circleOf(const Simulation& simulation, const std::string& model) {
  const auto velocity = simulation.read(model + "/true_velocity").value();
  return std::hypot(velocity[0], velocity[1]) / velocity[5];
}

TEST(Vehicle, aCarTurnsOnTheCircleOfItsSteeringAngle) {
  for (const double steering : {0.2, 0.4, -0.3}) {
    const auto simulation = yardWith(including("car"));
    commandPort(*simulation, "car/drive", {0.4, steering});
    runFor(*simulation, 4);
    EXPECT_NEAR(circleOf(*simulation, "car"), 0.32 / std::tan(steering),
                0.04 * std::abs(0.32 / std::tan(steering)))
        << steering;
    const auto velocity = simulation->read("car/true_velocity").value();
    EXPECT_NEAR(std::hypot(velocity[0], velocity[1]), 0.4, 0.01);
  }
}

TEST(Vehicle, theInnerFrontWheelIsSteeredMore) {
  const auto simulation = yardWith(including("car"));
  commandPort(*simulation, "car/drive", {0.3, 0.4});
  runFor(*simulation, 3);
  const double radius = 0.32 / std::tan(0.4);
  EXPECT_NEAR(portReading(*simulation, "car/kingpinL/position"), std::atan(0.32 / (radius - 0.13)), 0.02);
  EXPECT_NEAR(portReading(*simulation, "car/kingpinR/position"), std::atan(0.32 / (radius + 0.13)), 0.02);
  // The wheels of the driven axle turn at the speeds of their circles.
  const double left = portReading(*simulation, "car/axleRL/position"),
               right = portReading(*simulation, "car/axleRR/position");
  runFor(*simulation, 1);
  EXPECT_NEAR((portReading(*simulation, "car/axleRL/position") - left) * 0.05, 0.3 * (radius - 0.13) / radius,
              0.005);
  EXPECT_NEAR((portReading(*simulation, "car/axleRR/position") - right) * 0.05,
              0.3 * (radius + 0.13) / radius, 0.005);
}

TEST(Vehicle, aCarThatIsSteeredStraightStaysStraight) {
  const auto simulation = yardWith(including("car"));
  commandPort(*simulation, "car/drive", {0.5, 0});
  runFor(*simulation, 4);
  const Pose2 pose = groundPlace(*simulation, "car");
  EXPECT_GT(pose.x, 1.7);
  EXPECT_NEAR(pose.y, 0, 0.01);
  EXPECT_NEAR(pose.heading, 0, 0.01);
}

TEST(Vehicle, mecanumWheelsMoveItSidewaysObliquelyAndAround) {
  const struct {
    Motion wanted;
    const char* what;
  } cases[] = {{{0.3, 0, 0}, "ahead"},
               {{0, 0.3, 0}, "sideways"},
               {{0.2, -0.2, 0}, "obliquely"},
               {{0, 0, 1}, "around"}};
  for (const auto& one : cases) {
    const auto simulation = yardWith(including("omni"));
    commandPort(*simulation, "omni/drive", one.wanted);
    runFor(*simulation, 2);
    const auto velocity = simulation->read("omni/true_velocity").value();
    const double heading = groundPlace(*simulation, "omni").heading;
    const robotlink::Vector2 own =
        Eigen::Rotation2Dd(-heading) * robotlink::Vector2(velocity[0], velocity[1]);
    EXPECT_NEAR(own.x(), one.wanted[0], 0.02) << one.what;
    EXPECT_NEAR(own.y(), one.wanted[1], 0.02) << one.what;
    EXPECT_NEAR(velocity[5], one.wanted[2], 0.05) << one.what;
  }
}

TEST(Vehicle, castersFollowARobotOnTwoWheels) {
  const auto simulation = yardWith(trolley());
  commandPort(*simulation, "trolley/drive", {0.3, 0.3});
  runFor(*simulation, 3);
  EXPECT_NEAR(groundPlace(*simulation, "trolley").y, 0, 0.03);
  EXPECT_NEAR(portReading(*simulation, "trolley/swivel/position"), 0, 0.15) << "it trails";
  commandPort(*simulation, "trolley/drive", {-0.1, 0.1});
  runFor(*simulation, 4);
  const auto velocity = simulation->read("trolley/true_velocity").value();
  EXPECT_NEAR(velocity[5], 0.2 / 0.3, 0.05) << "on the spot it turns about its track";
  EXPECT_NEAR(std::abs(portReading(*simulation, "trolley/swivel/position")),
              robotlink::kPi / 2 + std::asin(0.03 / 0.15), 0.02)
      << "the caster rolls on its circle";
}

TEST(Vehicle, aTorqueAcceleratesACarAndItRollsOut) {
  const auto simulation = yardWith(replacedOnce(including("car"), "model://car", "model://torque_car"));
  commandPort(*simulation, "torque_car/drive", {0.06, 0});
  runFor(*simulation, 0.5);
  // 2 * 0.06 N m / 0.05 m on 6 kg, less the front wheels' resistance of 2 * 0.01 N m / 0.05 m.
  const auto velocity = simulation->read("torque_car/true_velocity").value();
  EXPECT_NEAR(velocity[0], 0.5 * (2.4 - 0.4) / 6, 0.04);
  commandPort(*simulation, "torque_car/drive", {0, 0});
  runFor(*simulation, 3);
  EXPECT_NEAR(simulation->read("torque_car/true_velocity").value()[0], 0, 0.005);
}

TEST(Vehicle, aWheelThatIsBlockedPushesNoHarderThanItsMotor) {
  const auto simulation = yardWith(including("car") + boxAt("wall", {0.8, 0, 0.1}, {0.1, 2, 0.2}));
  commandPort(*simulation, "car/drive", {0.5, 0});
  runFor(*simulation, 0.2);
  EXPECT_EQ(simulation->read("car/drive").value()[1], 1) << "nothing is in its way yet";
  runFor(*simulation, 4);
  EXPECT_EQ(simulation->read("car/drive").value()[1], 0) << "a wall is";
  EXPECT_LT(groundPlace(*simulation, "car").x, 0.75 - 0.41 + 0.005);
  commandPort(*simulation, "car/drive", {-0.3, 0});
  runFor(*simulation, 1);
  commandPort(*simulation, "car/drive", {-0.3, 0.1});
  runFor(*simulation, 0.5);
  EXPECT_EQ(simulation->read("car/drive").value()[1], 1) << "away from it, commands are executed again";
}

TEST(Vehicle, theShippedSceneIsDrivenByItsPorts) {
  const auto scene = Scene::load(ROBOTCONTROL_SOURCE_DIR "/resources/scenes/vehicles.sdf");
  ASSERT_TRUE(scene) << describe(scene.error());
  const auto simulation = std::move(Simulation::create(*scene, {.seed = 1, .noise = false}).value());
  runFor(*simulation, 0.5);
  const Pose2 car = groundPlace(*simulation, "car"), omni = groundPlace(*simulation, "omni"),
              ghost = groundPlace(*simulation, "ghost");
  commandPort(*simulation, "car/drive", {0.5, 0});
  commandPort(*simulation, "omni/drive", {0, -0.2, 0});
  commandPort(*simulation, "ghost/drive", {0.2, 0, 0.5});
  runFor(*simulation, 2);
  EXPECT_GT(groundPlace(*simulation, "car").x - car.x, 0.8);
  EXPECT_LT(groundPlace(*simulation, "omni").y - omni.y, -0.3);
  EXPECT_NEAR(groundPlace(*simulation, "ghost").heading - ghost.heading, 1, 0.1);
}

TEST(Vehicle, theSameSeedGivesTheSameBytes) {
  const auto digest = [](std::uint64_t seed) {
    const auto simulation = yardWith(including("car") + including("omni", "-2 1 0 0 0 0") + trolley(), seed);
    commandPort(*simulation, "car/drive", {0.4, 0.3});
    commandPort(*simulation, "omni/drive", {0.1, 0.2, 0.3});
    runFor(*simulation, 2);
    return simulation->digest();
  };
  EXPECT_EQ(digest(1), digest(1));
  EXPECT_NE(digest(1), digest(2));
}

TEST(Vehicle, whatIsWrongIsSaidWithItsLine) {
  const auto errorsOf = [](const std::string& from, const std::string& to) {
    return errorsOfModel("omni", from, to);
  };
  EXPECT_NE(errorsOf("kind=\"omni\"", "kind=\"tracked\"").find("omni or ackermann, not 'tracked'"),
            std::string::npos);
  EXPECT_NE(errorsOf("rollers=\"-0.785398\"", "rollers=\"2\"").find("from -1.4 to 1.4, not '2'"),
            std::string::npos);
  EXPECT_NE(errorsOf(">axleFL</robotcontrol:wheel>", ">axleXX</robotcontrol:wheel>")
                .find("the model has no joint 'axleXX'"),
            std::string::npos);
  EXPECT_NE(errorsOf("kind=\"omni\"", "kind=\"ackermann\"").find("needs <robotcontrol:steer>"),
            std::string::npos);
  EXPECT_NE(errorsOf("kind=\"omni\"", "kind=\"omni\" control=\"torque\"").find("of omni vehicles only speed"),
            std::string::npos);
  const std::string line = errorsOf("kind=\"omni\"", "kind=\"tracked\"");
  EXPECT_NE(line.find("model.sdf:"), std::string::npos) << line;
}

}  // namespace
}  // namespace simcore
