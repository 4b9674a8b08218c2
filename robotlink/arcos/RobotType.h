// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "robotlink/base/Geometry.h"

namespace robotlink::arcos {

/// The parameters of a kind of robot that a client needs: the factors that convert the numbers in packets to
/// SI units, and the poses of its sensors. Poses are in the robot's frame: origin on the ground at its center
/// of rotation, x to the front. A plain value.
struct RobotType {
  /// The subclass in the robot's handshake: "p3at-sh".
  std::string subclass;
  /// m per unit of the odometry.
  double distance = 0.001;
  /// rad per unit of the heading.
  double angle = 2 * kPi / 4096;
  /// m/s per unit of the wheels' speeds.
  double speed = 0.001;
  /// m per unit of a sonar's range.
  double range = 0.001;
  /// Effective distance of the wheels, m: what wheels without slip would need to turn as these do.
  double track = 0.588;
  /// m/s per unit of VEL2.
  double wheelSpeedStep = 0.02;
  /// Size of the body, m.
  double length = 0.626, width = 0.505;
  /// In the order of the sonars' numbers; each measures along its x-axis.
  std::vector<Pose2> sonarsInRobot;
  double sonarMaximum = 5.0;  ///< m; the reading if there is no echo
  /// The full cone, rad.
  double sonarOpeningAngle = radians(30.0);
  Pose2 laserInRobot = {0.125, 0, 0};
};

/// The parameters of a subclass; for an unknown one those of the p3at-sh, which all robots with this firmware
/// resemble.
RobotType robotType(const std::string& subclass);

}  // namespace robotlink::arcos
