// SPDX-License-Identifier: GPL-3.0-or-later
// Sensors of motion, place and force against mechanics.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>

#include "tests/simcore/truth/Bodies.h"
#include "tests/simcore/truth/TruthTable.h"

namespace simcore::truth {
namespace {

Vector3 vectorOf(const Simulation& simulation, const std::string& path, std::size_t first = 0) {
  return {read(simulation, path, first), read(simulation, path, first + 1),
          read(simulation, path, first + 2)};
}

/// A platform that a motor turns about the vertical; 0.5 m from the axis it carries an IMU and a gyroscope.
std::unique_ptr<Simulation> platform(const char* control) {
  return simulationOf(model(
      "platform", "0 0 1 0 0 0",
      inertial(4, Vector3::Constant(0.5)) + sensor("imu", "imu", "0.5 0 0 0 0 0") +
          sensor("gyro", "imu", "0.5 0 0 0 0 0.5",
                 "<imu><angular_velocity><x/><y/><z/></angular_velocity></imu>"),
      jointToWorld("revolute",
                   "<axis><xyz>0 0 1</xyz><limit><effort>1000</effort><velocity>50</velocity></limit></axis>",
                   fmt::format("<robotcontrol:speed_sensor/><robotcontrol:load_sensor/><robotcontrol:servo>"
                               "<robotcontrol:control>{}</robotcontrol:control></robotcontrol:servo>",
                               control))));
}

TEST(SensorTruth, onATurningPlatformInertialSensorsFeelItsTurn) {
  const double rate = 3, lever = 0.5;
  const auto simulation = platform("velocity");
  simulation->requestAngle(0, rate);
  advance(*simulation, 1);
  const Vector3 felt = vectorOf(*simulation, "platform/imu");
  // It is the mean acceleration of a step, which points half a step's turn back.
  const double centripetal = rate * rate * lever;
  compare(
      {"accelerometer on a platform, toward the axis", "w^2 r", -centripetal, 0.001 * centripetal, "m/s^2"},
      felt.x());
  compare({"accelerometer on a platform, along its way", "0", 0, centripetal * rate * kStepSeconds / 2 * 1.05,
           "m/s^2"},
          felt.y());
  compare({"accelerometer on a platform, upwards", "g", kGravity, 1e-3, "m/s^2"}, felt.z());
  compare({"gyroscope on a platform", "w", 0, 1e-4, "rad/s"},
          (vectorOf(*simulation, "platform/gyro") - Vector3(0, 0, rate)).norm());
  compare({"speed sensor of a joint", "w", rate, 1e-4, "rad/s"}, read(*simulation, "platform/joint/speed"));
}

TEST(SensorTruth, anAcceleratingPlatformIsFeltAlongItsWay) {
  const double torque = 1, inertia = 0.5, lever = 0.5;
  const auto simulation = platform("torque");
  simulation->requestAngle(0, torque);
  advance(*simulation, 0.4);
  const double acceleration = torque / inertia, rate = acceleration * 0.4;
  const Vector3 felt = vectorOf(*simulation, "platform/imu");
  const double halfStep = rate * rate * lever * rate * kStepSeconds / 2;
  compare({"accelerometer on an accelerating platform, along its way", "T r / I", acceleration * lever,
           halfStep * 1.05 + 1e-3, "m/s^2"},
          felt.y());
  compare({"accelerometer on an accelerating platform, toward the axis", "w^2 r", -rate * rate * lever,
           acceleration * kStepSeconds * rate * lever + 1e-3, "m/s^2"},
          felt.x());
}

TEST(SensorTruth, atRestInertialSensorsFeelGravityOnly) {
  const std::string tilted = "0 0 0 0.3 -0.4 0.5";
  const auto simulation = simulationOf(
      ground() + model("box", "0 0 0.05 0 0 0",
                       inertial(2, momentsOfBox(2, {0.2, 0.2, 0.1})) + solid(box({0.2, 0.2, 0.1})) +
                           sensor("imu", "imu", tilted) +
                           sensor("gyro", "imu", tilted,
                                  "<imu><angular_velocity><x/><y/><z/></angular_velocity></imu>")));
  advance(*simulation, 1);
  const Eigen::Matrix3d axes =
      (Eigen::AngleAxisd(0.5, Vector3::UnitZ()) * Eigen::AngleAxisd(-0.4, Vector3::UnitY()) *
       Eigen::AngleAxisd(0.3, Vector3::UnitX()))
          .toRotationMatrix();
  compare({"accelerometer at rest, tilted", "R^T g", 0, 0.005, "m/s^2"},
          (vectorOf(*simulation, "box/imu") - axes.transpose() * Vector3(0, 0, kGravity)).norm());
  compare({"gyroscope at rest", "0", 0, 1e-3, "rad/s"}, vectorOf(*simulation, "box/gyro").norm());
}

TEST(SensorTruth, inFreeFallNothingIsFelt) {
  const auto simulation = simulationOf(model("box", "0 0 50 0 0 0",
                                             inertial(2, Vector3::Constant(0.1)) + sensor("imu", "imu") +
                                                 sensor("gps", "navsat") + sensor("height", "altimeter")));
  advance(*simulation, 1);
  compare({"accelerometer in free fall", "0", 0, 1e-9, "m/s^2"}, vectorOf(*simulation, "box/imu").norm());
  const double fallen = kGravity / 2, late = kGravity * kStepSeconds / 2 * 1.001;
  compare({"altimeter after a fall of 1 s", "-g t^2 / 2", -fallen, late, "m"},
          read(*simulation, "box/height"));
  compare({"altimeter, vertical speed", "-g t", -kGravity, 1e-9, "m/s"}, read(*simulation, "box/height", 1));
  compare({"navsat after a fall of 1 s", "z - g t^2 / 2", 50 - fallen, late, "m"},
          read(*simulation, "box/gps", 2));
  compare({"navsat, vertical speed", "-g t", -kGravity, 1e-9, "m/s"}, read(*simulation, "box/gps", 5));
}

TEST(SensorTruth, magnetometersMeasureTheFieldInTheirAxes) {
  const Vector3 field(2e-5, -1e-5, -4e-5);
  const auto simulation = simulationOf(
      "<magnetic_field>2e-5 -1e-5 -4e-5</magnetic_field><gravity>0 0 0</gravity>" +
      model("box", "1 2 3 0.4 0.5 0.6",
            inertial(2, Vector3::Constant(0.1)) + sensor("compass", "magnetometer", "0 0 0 0 0 0.7")));
  const Eigen::Matrix3d axes =
      (Eigen::AngleAxisd(0.6, Vector3::UnitZ()) * Eigen::AngleAxisd(0.5, Vector3::UnitY()) *
       Eigen::AngleAxisd(0.4, Vector3::UnitX()) * Eigen::AngleAxisd(0.7, Vector3::UnitZ()))
          .toRotationMatrix();
  compare({"magnetometer, turned about all axes", "R^T B", 0, 1e-14, "T"},
          (vectorOf(*simulation, "box/compass") - axes.transpose() * field).norm());
}

TEST(SensorTruth, odometryOfACircleIsTheCircle) {
  const auto simulation = simulationOf(
      ground() +
      model("cart", "3 4 0.05 0 0 1",
            inertial(4, {0.03, 0.06, 0.08}) + solid(box({0.4, 0.3, 0.1}), 0.1) +
                customSensor("odometry", "<robotcontrol:odometry/>") + sensor("gps", "navsat"),
            "<robotcontrol:guided kind='omni'><robotcontrol:acceleration>50</robotcontrol:acceleration>"
            "</robotcontrol:guided>"));
  ASSERT_TRUE(simulation->write("cart/motion", std::vector<double>{0.5, 0, 1}));
  advance(*simulation, 2);
  const Pose3 start(Eigen::Translation3d(3, 4, 0) * Eigen::AngleAxisd(1, Vector3::UnitZ()));
  const robotlink::Pose2 moved = robotlink::groundPose(start.inverse() * *simulation->modelPose("cart"));
  // What was driven is a circle of v / w = 0.5 m, but for the acceleration at the start.
  compare({"guided model on a circle, way ahead after 2 s", "v / w sin(w t)", 0.5 * std::sin(2.0), 0.02, "m"},
          moved.x);
  compare({"guided model on a circle, way aside after 2 s", "v / w (1 - cos(w t))", 0.5 * (1 - std::cos(2.0)),
           0.03, "m"},
          moved.y);
  compare({"odometry, error of the place after 2 s", "the way from the start", 0, 1e-9, "m"},
          std::hypot(read(*simulation, "cart/odometry", 0) - moved.x,
                     read(*simulation, "cart/odometry", 1) - moved.y));
  compare({"odometry, error of the heading after 2 s", "the turn from the start", moved.heading, 1e-9, "rad"},
          read(*simulation, "cart/odometry", 2));
  const Vector3 velocity = vectorOf(*simulation, "cart/gps", 3);
  compare({"navsat, speed of a guided model", "v", 0.5, 0.01, "m/s"}, velocity.norm());
}

TEST(SensorTruth, contactsAndSwitchesCloseWhereSolidsTouch) {
  const std::string body =
      inertial(1, momentsOfBox(1, {0.1, 0.1, 0.1})) + solid(box({0.1, 0.1, 0.1})) +
      sensor("contact", "contact", "0 0 0 0 0 0", "<contact><collision>solid</collision></contact>") +
      customSensor("switch", "<robotcontrol:switch/>");
  const auto simulation = simulationOf(ground() + model("box", "0 0 0.55 0 0 0", body));
  // It falls 0.5 m, which takes sqrt(2 h / g).
  double closed = 0, pressed = 0;
  for (int i = 1; i <= 150; ++i) {
    simulation->step();
    if (closed == 0 && read(*simulation, "box/contact") == 1) closed = i * kStepSeconds;
    if (pressed == 0 && read(*simulation, "box/switch") == 1) pressed = i * kStepSeconds;
  }
  const double time = std::sqrt(2 * 0.5 / kGravity);
  compare({"contact, instant at which a fall of 0.5 m ends", "sqrt(2 h / g)", time, 2 * kStepSeconds, "s"},
          closed);
  compare({"switch, instant at which a fall of 0.5 m ends", "sqrt(2 h / g)", time, 2 * kStepSeconds, "s"},
          pressed);
}

/// A body of 2 kg that hangs 0.4 m beside a joint, whose force-torque sensor measures in the child's frame.
TEST(SensorTruth, aForceTorqueSensorWeighsWhatHangsOnIt) {
  const auto simulation = simulationOf(
      ground() +
      model("crane", "0 0 0.5 0 0 0", inertial(500, momentsOfBox(500, {1, 1, 1})) + solid(box({1, 1, 1})),
            "<link name='arm'><pose>0 0 0.6 0 0 0</pose>" +
                inertial(2, Vector3::Constant(0.02), {0.4, 0, 0}) +
                "</link><joint name='wrist' type='revolute'><parent>body</parent><child>arm</child>"
                "<axis><xyz>0 1 0</xyz><limit><lower>-1</lower><upper>1</upper><effort>100</effort>"
                "<velocity>1</velocity></limit></axis><robotcontrol:servo/><robotcontrol:load_sensor/>"
                "<sensor name='wrench' type='force_torque'/></joint>"));
  advance(*simulation, 2);
  const double weight = 2 * kGravity;
  // The solver's forces tremble from step to step, so they are weighed over a second.
  Vector3 force = Vector3::Zero(), torque = Vector3::Zero();
  double load = 0, square = 0;
  constexpr int kSamples = 250;
  for (int i = 0; i < kSamples; ++i) {
    simulation->step();
    const Vector3 now = vectorOf(*simulation, "crane/wrench");
    force += now / kSamples;
    torque += vectorOf(*simulation, "crane/wrench", 3) / kSamples;
    load += std::abs(read(*simulation, "crane/wrist/load")) / kSamples;
    square += std::pow(now.z() + weight, 2) / kSamples;
  }
  // SDFormat's default is what the child exerts on the parent, in the child's frame.
  compare({"force-torque sensor, force of a hung body, mean of 1 s", "m g", 0, 0.01 * weight, "N"},
          (force - Vector3(0, 0, -weight)).norm());
  compare({"force-torque sensor, force of a hung body, root mean square of the trembling", "0", 0,
           0.1 * weight, "N"},
          std::sqrt(square));
  compare({"force-torque sensor, torque of its lever, mean of 1 s", "r x m g", 0, 0.01 * weight * 0.4, "N m"},
          (torque - Vector3(0.4, 0, 0).cross(Vector3(0, 0, -weight))).norm());
  compare(
      {"load sensor of a joint with a lever, mean of 1 s", "m g l", weight * 0.4, 0.01 * weight * 0.4, "N m"},
      load);
}

TEST(SensorTruth, aBatteryGivesWhatTimeAndWorkTake) {
  const double inertia = 0.5, torque = 2;
  const auto simulation = simulationOf(model(
      "wheel", "0 0 1 0 0 0",
      inertial(4, Vector3::Constant(inertia)) +
          customSensor("battery",
                       "<robotcontrol:battery><robotcontrol:capacity>200</robotcontrol:capacity>"
                       "<robotcontrol:idle_power>3</robotcontrol:idle_power>"
                       "<robotcontrol:efficiency>0.5</robotcontrol:efficiency>"
                       "<robotcontrol:full_voltage>12</robotcontrol:full_voltage>"
                       "<robotcontrol:empty_voltage>10</robotcontrol:empty_voltage></robotcontrol:battery>"),
      jointToWorld(
          "revolute",
          "<axis><xyz>0 0 1</xyz><limit><effort>10</effort><velocity>50</velocity></limit></axis>",
          "<robotcontrol:servo><robotcontrol:control>torque</robotcontrol:control></robotcontrol:servo>")));
  simulation->requestAngle(0, torque);
  advance(*simulation, 2);
  const double rate = torque / inertia * 2, energy = 3 * 2 + inertia * rate * rate / 2 / 0.5;
  compare({"battery, charge after 2 s of work", "1 - (P t + I w^2 / 2 / efficiency) / capacity",
           1 - energy / 200, 0.001, ""},
          read(*simulation, "wheel/battery", 1));
  compare(
      {"battery, voltage after 2 s of work", "linear in the charge", 10 + 2 * (1 - energy / 200), 0.002, "V"},
      read(*simulation, "wheel/battery", 0));
}

}  // namespace
}  // namespace simcore::truth
