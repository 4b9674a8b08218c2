// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "robotlink/base/Geometry.h"

namespace robotlink::arcos {

/// What a client must know of a kind of robot to understand it: the factors that turn the numbers of its
/// packets into SI, and where its sensors are. Poses are in the robot's frame: its origin on the ground at
/// the centre it turns about, x to the front.
struct RobotType {
  std::string subclass;           // as the robot tells it in the handshake: "p3at-sh"
  double distance = 0.001;        // m in a unit of the odometry
  double angle = 2 * kPi / 4096;  // rad in a unit of the heading
  double speed = 0.001;           // m/s in a unit of the wheels' speeds
  double range = 0.001;           // m in a unit of a sonar's range
  double track = 0.588;  // m: how far apart two wheels without slip would be that turn it as its wheels do
  double wheelSpeedStep = 0.02;          // m/s in a unit of VEL2
  double length = 0.626, width = 0.505;  // m
  std::vector<Pose2> sonarsInRobot;
  double sonarMaximum = 5.0;                 // m; what no echo reads
  double sonarOpeningAngle = radians(30.0);  // of the whole cone
  Pose2 laserInRobot = {0.125, 0, 0};
};

/// The type of a subclass; one that is not known is taken for a p3at-sh, which all robots of this firmware
/// resemble.
RobotType robotType(const std::string& subclass);

}  // namespace robotlink::arcos
