// SPDX-License-Identifier: GPL-3.0-or-later
// Motors of joints, and models that move as they are commanded.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/simcore/SensorScenes.h"

namespace simcore {
namespace {

/// A cart with a flywheel on a vertical axis.
std::unique_ptr<Simulation> flywheel(const std::string& servo, const std::string& effort = "0.05") {
  return cartWith("", R"(<link name="disk"><pose>0 0 0.2 0 0 0</pose>
      <inertial><mass>0.5</mass><inertia><ixx>0.002</ixx><iyy>0.002</iyy><izz>0.004</izz>
      <ixy>0</ixy><ixz>0</ixz><iyz>0</iyz></inertia></inertial></link>
    <joint name="axle" type="revolute"><parent>base</parent><child>disk</child>
      <axis><xyz>0 0 1</xyz><limit><lower>-3</lower><upper>3</upper><effort>)" +
                          effort + R"(</effort><velocity>10</velocity></limit></axis>
      <robotcontrol:speed_sensor/><robotcontrol:servo>)" +
                          servo + "</robotcontrol:servo></joint>");
}

/// A block of 1 kg that a motor moves along x, without weight, from 0 to 1 m; it starts at `start`.
std::unique_ptr<Simulation> slide(const std::string& servo, const std::string& start = "0",
                                  const std::string& effort = "2") {
  return cartWith("", "",
                  R"(<model name="slide"><pose>0 5 1 0 0 0</pose><link name="block"><gravity>false</gravity>
      <inertial><mass>1</mass><inertia><ixx>0.01</ixx><iyy>0.01</iyy><izz>0.01</izz>
      <ixy>0</ixy><ixz>0</ixz><iyz>0</iyz></inertia></inertial></link>
    <joint name="rail" type="prismatic"><parent>world</parent><child>block</child>
      <axis><xyz>1 0 0</xyz><limit><lower>0</lower><upper>1</upper><effort>)" +
                      effort + R"(</effort><velocity>0.5</velocity></limit></axis>
      <robotcontrol:speed_sensor/><robotcontrol:load_sensor/><robotcontrol:servo><robotcontrol:initial_position>)" +
                      start + "</robotcontrol:initial_position>" + servo +
                      "</robotcontrol:servo></joint></model>");
}

double value(const Simulation& simulation, const std::string& path) {
  auto values = simulation.read(path);
  EXPECT_TRUE(values) << path;
  return values ? values->front() : 0;
}

void advance(Simulation& simulation, int steps) {
  for (int i = 0; i < steps; ++i) simulation.step();
}

std::unique_ptr<Simulation> guided(const std::string& kind, const std::string& inGuided = "",
                                   const std::string& world = "") {
  return cartWith("", "<robotcontrol:guided kind='" + kind + "'>" + inGuided + "</robotcontrol:guided>",
                  world);
}

TEST(ActuatorsTest, aVelocityMotorTurnsAtItsSpeed) {
  const auto simulation = flywheel("<robotcontrol:control>velocity</robotcontrol:control>");
  ASSERT_TRUE(simulation);
  ASSERT_TRUE(simulation->write("cart/axle/speed_request", std::vector<double>{2}));
  advance(*simulation, 100);
  EXPECT_NEAR(value(*simulation, "cart/axle/speed"), 2, 0.01);
  EXPECT_TRUE(simulation->servoState(0).reached);
}

TEST(ActuatorsTest, aTorqueMotorAcceleratesByItsTorque) {
  const auto simulation = flywheel("<robotcontrol:control>torque</robotcontrol:control>");
  ASSERT_TRUE(simulation);
  ASSERT_TRUE(simulation->write("cart/axle/torque_request", std::vector<double>{0.01}));
  advance(*simulation, 50);
  // 0.01 N m on 0.004 kg m^2 for 0.2 s; the cart is turned a little the other way.
  EXPECT_NEAR(value(*simulation, "cart/axle/speed"), 0.5, 0.04);
}

TEST(ActuatorsTest, aServoWithGainsSwingsAndADampedOneDoesNot) {
  const auto overshootOf = [](const char* damping) {
    const auto simulation = flywheel(
        std::string("<robotcontrol:p>0.4</robotcontrol:p><robotcontrol:d>") + damping + "</robotcontrol:d>",
        "1");
    double most = 0;
    simulation->requestAngle(0, 1);
    for (int i = 0; i < 400; ++i) {
      simulation->step();
      most = std::max(most, value(*simulation, "cart/axle/position"));
    }
    EXPECT_NEAR(value(*simulation, "cart/axle/position"), 1, 0.6);
    return most - 1;
  };
  // Critical damping is 2 sqrt(p * inertia) = 0.08.
  EXPECT_GT(overshootOf("0.005"), 0.3);
  EXPECT_LT(overshootOf("0.09"), 0.02);
}

TEST(ActuatorsTest, theIntegralHoldsAWeightThatAProportionalServoCannot) {
  const auto errorOf = [](const char* integral) {
    const auto simulation =
        cartWith("", R"(<link name="arm"><pose>0 0 0.5 0 0 0</pose>
        <inertial><pose>0.3 0 0 0 0 0</pose><mass>0.2</mass><inertia><ixx>0.001</ixx><iyy>0.001</iyy><izz>0.001</izz>
        <ixy>0</ixy><ixz>0</ixz><iyz>0</iyz></inertia></inertial></link>
      <joint name="shoulder" type="revolute"><parent>base</parent><child>arm</child>
        <axis><xyz>0 -1 0</xyz><limit><lower>-1.5</lower><upper>1.5</upper><effort>5</effort><velocity>5</velocity></limit></axis>
        <robotcontrol:servo><robotcontrol:p>4</robotcontrol:p><robotcontrol:d>0.6</robotcontrol:d><robotcontrol:i>)" +
                         std::string(integral) + "</robotcontrol:i></robotcontrol:servo></joint>");
    advance(*simulation, 1000);
    return std::abs(value(*simulation, "cart/shoulder/position"));
  };
  EXPECT_NEAR(errorOf("0"), 0.3 * 0.2 * 9.81 / 4, 0.02);
  EXPECT_LT(errorOf("10"), 0.01);
}

TEST(ActuatorsTest, aCommandCountsAfterItsDelay) {
  const auto simulation = flywheel(
      "<robotcontrol:control>velocity</robotcontrol:control><robotcontrol:delay>0.1</robotcontrol:delay>");
  ASSERT_TRUE(simulation);
  simulation->requestAngle(0, 2);
  advance(*simulation, 25);
  EXPECT_NEAR(value(*simulation, "cart/axle/speed"), 0, 1e-3);
  advance(*simulation, 75);
  EXPECT_NEAR(value(*simulation, "cart/axle/speed"), 2, 0.01);
}

TEST(ActuatorsTest, aPositionServoMovesASlide) {
  const auto simulation = slide("", "0.25", "50");
  ASSERT_TRUE(simulation);
  EXPECT_EQ(simulation->port("slide/rail/position")->info.unit, "m");
  EXPECT_EQ(simulation->port("slide/rail/request")->info.maximum, 1);
  EXPECT_NEAR(value(*simulation, "slide/rail/position"), 0.25, 1e-9);
  EXPECT_NEAR(simulation->modelPose("slide")->translation().x(), 0.25, 1e-9) << "it starts there";
  ASSERT_TRUE(simulation->write("slide/rail/request", std::vector<double>{0.75}));
  // 0.5 m at 0.5 m/s.
  advance(*simulation, 125);
  EXPECT_NEAR(value(*simulation, "slide/rail/speed"), 0.5, 0.05);
  advance(*simulation, 200);
  EXPECT_NEAR(value(*simulation, "slide/rail/position"), 0.75, 1e-3);
  EXPECT_NEAR(simulation->modelPose("slide")->translation().x(), 0.75, 1e-3);
  EXPECT_TRUE(simulation->servoState(0).reached);
  ASSERT_TRUE(simulation->write("slide/rail/request", std::vector<double>{5}));
  advance(*simulation, 400);
  EXPECT_NEAR(value(*simulation, "slide/rail/position"), 1, 1e-3) << "the command is limited to the range";
}

TEST(ActuatorsTest, aVelocityMotorMovesASlide) {
  const auto simulation = slide("<robotcontrol:control>velocity</robotcontrol:control>");
  ASSERT_TRUE(simulation);
  ASSERT_TRUE(simulation->write("slide/rail/speed_request", std::vector<double>{0.2}));
  advance(*simulation, 250);
  EXPECT_NEAR(value(*simulation, "slide/rail/speed"), 0.2, 0.005);
  EXPECT_EQ(simulation->port("slide/rail/speed")->info.unit, "m/s");
  EXPECT_NEAR(value(*simulation, "slide/rail/position"), 0.2, 0.03);
}

TEST(ActuatorsTest, aForceMotorAcceleratesASlide) {
  const auto simulation = slide("<robotcontrol:control>torque</robotcontrol:control>");
  ASSERT_TRUE(simulation);
  ASSERT_TRUE(simulation->write("slide/rail/force_request", std::vector<double>{0.5}));
  advance(*simulation, 100);
  // 0.5 N on 1 kg for 0.4 s.
  EXPECT_NEAR(value(*simulation, "slide/rail/speed"), 0.2, 0.02);
  EXPECT_NEAR(value(*simulation, "slide/rail/load"), 0.5, 0.02);
  EXPECT_EQ(simulation->port("slide/rail/load")->info.unit, "N");
}

TEST(ActuatorsTest, whatFliesGoesInSixDegreesOfFreedom) {
  const auto simulation = guided("free");
  ASSERT_TRUE(simulation);
  advance(*simulation, 100);
  EXPECT_NEAR(simulation->modelPose("cart")->translation().z(), 0.05, 0.002) << "without a command it hovers";
  ASSERT_TRUE(simulation->write("cart/motion", std::vector<double>{0.2, 0, 0.5, 0.5, 0, 0}));
  advance(*simulation, 250);
  const Pose3 pose = *simulation->modelPose("cart");
  EXPECT_GT(pose.translation().z(), 0.4);
  EXPECT_NEAR(std::atan2(pose.linear()(2, 1), pose.linear()(2, 2)), 0.5, 0.03) << "rolled by 0.5 rad/s";
  EXPECT_TRUE(simulation->guideState(0).reached);
}

TEST(ActuatorsTest, aVehicleWithASteeringAxleDrivesCircles) {
  const auto simulation = guided("ackermann", R"(<robotcontrol:wheelbase>0.4</robotcontrol:wheelbase>
      <robotcontrol:acceleration>50</robotcontrol:acceleration>
      <robotcontrol:angular_acceleration>200</robotcontrol:angular_acceleration>)");
  ASSERT_TRUE(simulation);
  // A circle of radius 0.4 / tan(0.5) = 0.73 m, a quarter of it.
  ASSERT_TRUE(simulation->write("cart/motion", std::vector<double>{0.5, 0.5}));
  const double radius = 0.4 / std::tan(0.5);
  const int steps = static_cast<int>(radius * robotlink::kPi / 2 / 0.5 / 0.004);
  advance(*simulation, steps);
  const robotlink::Pose2 pose = robotlink::groundPose(*simulation->modelPose("cart"));
  EXPECT_NEAR(pose.heading, robotlink::kPi / 2, 0.05);
  EXPECT_NEAR(pose.x, radius, 0.04);
  EXPECT_NEAR(pose.y, radius, 0.04);
}

TEST(ActuatorsTest, sidesAndSkidTurnAVehicle) {
  const char* const fast =
      "<robotcontrol:track>0.5</robotcontrol:track><robotcontrol:skid>0.5</robotcontrol:skid>"
      "<robotcontrol:angular_acceleration>200</robotcontrol:angular_acceleration>";
  const auto headingOf = [&](const char* kind) {
    const auto simulation = guided(kind, fast);
    EXPECT_TRUE(simulation->write("cart/motion", std::vector<double>{-0.2, 0.2}));
    advance(*simulation, 250);
    return robotlink::groundPose(*simulation->modelPose("cart")).heading;
  };
  EXPECT_NEAR(headingOf("differential"), 0.8, 0.03);
  EXPECT_NEAR(headingOf("skid"), 0.4, 0.03);
}

TEST(ActuatorsTest, anObstacleStopsAGuidedModelAndIsTold) {
  for (const char* kind : {"omni", "walk"}) {
    const auto simulation = guided(kind, "", solidAt("wall", "1 0 0.25 0 0 0", "0.2 2 0.5"));
    ASSERT_TRUE(simulation);
    ASSERT_TRUE(simulation->write("cart/motion", std::vector<double>{0.5, 0, 0}));
    advance(*simulation, 100);
    EXPECT_TRUE(simulation->guideState(0).unobstructed) << kind;
    EXPECT_TRUE(simulation->guideState(0).reached) << kind;
    advance(*simulation, 500);
    EXPECT_NEAR(simulation->modelPose("cart")->translation().x(), 0.7, 0.02) << kind;
    EXPECT_FALSE(simulation->guideState(0).unobstructed) << kind;
    EXPECT_FALSE(simulation->guideState(0).reached) << kind;
    ASSERT_TRUE(simulation->write("cart/motion", std::vector<double>{-0.5, 0, 0}));
    // It brakes first, with its limited acceleration.
    advance(*simulation, 60);
    ASSERT_TRUE(simulation->write("cart/motion", std::vector<double>{-0.5, 0, 0}));
    advance(*simulation, 50);
    EXPECT_TRUE(simulation->guideState(0).unobstructed) << kind;
  }
}

}  // namespace
}  // namespace simcore
