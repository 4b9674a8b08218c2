// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "robotlink/base/Geometry.h"
#include "robotlink/base/GlobalPosition.h"

namespace robotlink::arcos {

/// What the robot's senses tell its microcontroller, ranges apart. SI units and radians.
struct RobotSensing {
  double leftTravel = 0, rightTravel = 0;  ///< m of the wheels' rims, as the encoders count them
  double leftSpeed = 0, rightSpeed = 0;    ///< m/s
  bool leftBlocked = false, rightBlocked = false;
  std::uint8_t frontBumpers = 0,
               rearBumpers = 0;  ///< bit i: segment i is pressed, counted from the left, the front up
  bool stopButton = false;       ///< held: the motors are off, whatever the client says
  double battery = 12.8;         ///< V
  double charge = 1;             ///< 0 to 1
  double rotationRate = 0;       ///< rad/s, of the gyroscope
  double temperature = 25;       ///< degC
  Pose2 truePose;
  double trueHeight = 0;
  std::optional<GlobalPosition> globalPosition;  ///< where the world is georeferenced
  double odometryError = 0;  ///< share by which the ways that the odometry measures are too long
};

/// How the microcontroller comes by ranges; called within step(), for what is due then and nothing else.
class RangeFinders {
 public:
  virtual ~RangeFinders() = default;
  /// m; where there is no echo, the sonars' maximum or more.
  virtual double sonar(int number) = 0;
  /// All readings that the device can make, m, counter-clockwise; valid until the next call.
  virtual std::span<const double> laser() = 0;
};

}  // namespace robotlink::arcos
