// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "robotlink/base/Geometry.h"

namespace modules {

/// Another robot, seen in one image, with what is known of the error of its place.
struct PlayerSight {
  std::string team;
  /// Meters.
  robotlink::Vector2 positionInRobot = robotlink::Vector2::Zero();
  /// From 0 to 1.
  double confidence = 0;
};

/// The part of the ground in which another robot would be seen: a sector around the robot. A plain value.
struct SeenSector {
  robotlink::Pose2 robotInField;
  /// The angle of its middle from the robot's x-axis, and half of its opening, rad; an opening of 0 shows
  /// nothing.
  double bearing = 0, halfOpening = 0;
  /// Meters.
  double nearest = 0.3, farthest = 0;

  bool contains(const robotlink::Vector2& inField) const {
    const robotlink::Vector2 inRobot = robotInField.inverse() * inField;
    const double distance = inRobot.norm();
    if (distance < nearest || distance > farthest) return false;
    return std::abs(robotlink::normalizedAngle(std::atan2(inRobot.y(), inRobot.x()) - bearing)) < halfOpening;
  }
};

/// The information of one image about other robots.
struct PlayerFrame {
  /// The time on any clock, s.
  double time = 0;
  robotlink::Pose2 robotInField;
  /// Standard deviations of that pose, m and rad.
  double positionDeviation = 0, headingDeviation = 0;
  SeenSector sector;
  std::vector<PlayerSight> seen;
};

}  // namespace modules
