// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "robotlink/arcos/server/GripperControl.h"
#include "robotlink/base/Geometry.h"
#include "robotlink/base/GlobalPosition.h"

namespace robotlink::arcos {

/// The sensor readings of the microcontroller, except for ranges. SI units and radians.
struct RobotSensing {
  /// Travel of the wheels' rims by the encoders, m.
  double leftTravel = 0, rightTravel = 0;
  /// Meters per second.
  double leftSpeed = 0, rightSpeed = 0;
  // The wheel does not turn although it is driven.
  bool leftBlocked = false, rightBlocked = false;
  /// Bit i: segment i is pressed; the front segments count from the left.
  std::uint8_t frontBumpers = 0, rearBumpers = 0;
  /// Pressed: the motors are off, whatever the client commands.
  bool stopButton = false;
  /// Volts.
  double battery = 12.8;
  /// State of charge, 0 to 1.
  double charge = 1;
  /// Rate measured by the gyroscope, rad/s, counterclockwise.
  double rotationRate = 0;
  double temperature = 25;  ///< degC
  /// Only of a robot that has a gripper.
  GripperSensing gripper;
  /// The reading of a GPS receiver at the line AUX1; empty if there is none.
  std::optional<GlobalPosition> gps;
  /// Ground truth in the field, m and rad, for SIM_STAT.
  Pose2 truePose;
  double trueHeight = 0;
  /// Only if the world is georeferenced.
  std::optional<GlobalPosition> globalPosition;
  /// The fraction by which the odometry overestimates distances.
  double odometryError = 0;
};

/// The source of ranges. Called only during ServerSession::step(), and only for sensors that are due, so that
/// ranges are computed on demand.
class RangeFinders {
 public:
  virtual ~RangeFinders() = default;
  /// The range in m; without an echo, the sonars' maximum or more.
  virtual double sonar(int number) = 0;
  /// All readings of the device, m, counterclockwise; valid until the next call.
  virtual std::span<const double> laser() = 0;
};

}  // namespace robotlink::arcos
