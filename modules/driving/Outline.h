// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "robotlink/base/Geometry.h"

namespace modules {

/// The body of a robot on wheels, from above: a rectangle around its center of rotation.
struct Outline {
  /// In m; the defaults are those of a Pioneer 3-AT.
  double halfLength = 0.313, halfWidth = 0.2525;

  /// The distance from a point in the robot's frame to the body, m; 0 inside.
  double distance(const robotlink::Vector2& point) const {
    return std::hypot(std::max(0.0, std::abs(point.x()) - halfLength),
                      std::max(0.0, std::abs(point.y()) - halfWidth));
  }
  /// The radius of the circumscribed circle, m.
  double radius() const { return std::hypot(halfLength, halfWidth); }
};

/// A velocity in the robot's frame: forward and counterclockwise.
struct DriveVelocity {
  /// Meters per second.
  double forward = 0;
  /// Radians per second.
  double rotation = 0;
  bool operator==(const DriveVelocity&) const = default;
};

/// The limits of a robot on wheels; the defaults are those of a Pioneer 3-AT.
struct DriveLimits {
  double speed = 0.75, rotation = robotlink::radians(100);                    ///< m/s and rad/s
  double acceleration = 0.3, rotationAcceleration = robotlink::radians(100);  ///< m/s^2 and rad/s^2
};

}  // namespace modules
