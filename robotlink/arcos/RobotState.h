// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Geometry.h"

namespace robotlink::arcos {

/// The latest range that one sonar measured.
struct SonarReading {
  Pose2 sensorInRobot;
  double range =
      0;  // m along the sensor's x-axis; the sonars' maximum if there was no echo, or it has not measured yet
  bool echo = false;  // something is there
  Instant time;       // when the packet with it came
  Pose2 robot;        // by odometry, then

  /// Where the echo came from, if it was on the sensor's axis; in the frame of the robot as it stood then.
  Vector2 pointInRobot() const { return sensorInRobot * Vector2(range, 0); }
  bool operator==(const SonarReading&) const = default;
};

/// What a Pioneer says of itself, each 100 ms. SI units and radians; a plain value.
struct RobotState {
  Instant time;  // when its packet came, by the clock of the one who reads

  /// By the robot's odometry: since it was switched on, connected to, or set to 0. Never wraps.
  /// Its heading is rough: wheels that skid are no compass.
  Pose2 pose;
  double speed = 0;                      // m/s, forwards
  double rotation = 0;                   // rad/s, counter-clockwise
  double leftSpeed = 0, rightSpeed = 0;  // m/s of the wheels' rims

  bool moving = false;
  bool motorsOn = false;
  bool sonarOn = false;
  bool emergencyStop = false;  // its button is pressed
  bool leftStalled = false, rightStalled = false;
  std::uint8_t frontBumpers = 0, rearBumpers = 0;  // bit i: segment i is pressed; all 0 where there are none

  double battery = 0;                   // V
  std::optional<double> stateOfCharge;  // 0 to 1
  std::optional<bool> charging;
  std::optional<double> temperature;  // degC

  std::uint8_t digitalIn = 0, digitalOut = 0;
  std::uint8_t analogIn = 0;                // 0 to 255 for 0 to 5 V, of the port chosen by ADSEL
  std::uint16_t flags = 0, faultFlags = 0;  // as in the packet: see StandardInformation.h

  std::vector<SonarReading> sonars;  // by number; each the latest there is

  bool stalled() const { return leftStalled || rightStalled; }
  bool bumped() const { return frontBumpers != 0 || rearBumpers != 0; }
  bool operator==(const RobotState&) const = default;
};

}  // namespace robotlink::arcos
