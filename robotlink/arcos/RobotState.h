// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "robotlink/arcos/GripperState.h"
#include "robotlink/base/Clock.h"
#include "robotlink/base/Geometry.h"

namespace robotlink::arcos {

/// The latest range measured by one sonar.
struct SonarReading {
  Pose2 sensorInRobot;
  /// In m along the sensor's x-axis; the sonars' maximum if there was no echo or no measurement yet.
  double range = 0;
  /// Whether the sonar saw something.
  bool echo = false;
  /// When its packet arrived.
  Instant time;
  /// The robot's pose by odometry at that time.
  Pose2 robot;

  /// The position of the echo, assuming it was on the sensor's axis, in the robot's frame at that time.
  Vector2 pointInRobot() const { return sensorInRobot * Vector2(range, 0); }
  bool operator==(const SonarReading&) const = default;
};

/// The state that a Pioneer sends every 100 ms, in SI units and radians. A plain value.
struct RobotState {
  /// When its packet arrived, by the client's clock.
  Instant time;

  /// The pose by odometry, whose origin is where the robot was switched on, connected or reset. x and y do
  /// not wrap; the heading is in (-pi, pi]. The heading is inaccurate because the wheels slip.
  Pose2 pose;
  /// Forwards, m/s.
  double speed = 0;
  /// Counter-clockwise, rad/s; from a gyroscope if the robot sends its rate.
  double rotation = 0;
  /// Speeds of the wheels' rims, m/s.
  double leftSpeed = 0, rightSpeed = 0;

  bool moving = false;
  bool motorsOn = false;
  bool sonarOn = false;
  /// The emergency stop button is pressed.
  bool emergencyStop = false;
  bool leftStalled = false, rightStalled = false;
  /// Bit i: bumper segment i is pressed; 0 if there are no bumpers.
  std::uint8_t frontBumpers = 0, rearBumpers = 0;

  /// Voltage, V.
  double battery = 0;
  /// From 0 to 1. Empty optionals were not sent by the robot.
  std::optional<double> stateOfCharge;
  std::optional<bool> charging;
  /// Degrees Celsius.
  std::optional<double> temperature;

  /// Every robot sends it, also those without a gripper.
  std::optional<GripperState> gripper;

  std::uint8_t digitalIn = 0, digitalOut = 0;
  /// The port selected by ADSEL; 0 to 255 for 0 to 5 V.
  std::uint8_t analogIn = 0;
  /// The flags as in the packet: see StandardInformation.h.
  std::uint16_t flags = 0, faultFlags = 0;

  /// The latest reading of each sonar, in the order of their numbers.
  std::vector<SonarReading> sonars;

  bool stalled() const { return leftStalled || rightStalled; }
  bool bumped() const { return frontBumpers != 0 || rearBumpers != 0; }
  bool operator==(const RobotState&) const = default;
};

}  // namespace robotlink::arcos
