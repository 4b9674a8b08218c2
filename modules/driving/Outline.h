// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "robotlink/base/Geometry.h"

namespace modules {

/// The body of a robot on wheels, from above: a rectangle about the point that it turns about.
struct Outline {
  double halfLength = 0.313, halfWidth = 0.2525;  ///< m

  /// m, from a point in the robot's frame to the body; 0 within it.
  double distance(const robotlink::Vector2& point) const {
    return std::hypot(std::max(0.0, std::abs(point.x()) - halfLength),
                      std::max(0.0, std::abs(point.y()) - halfWidth));
  }
  /// m, of the circle about it.
  double radius() const { return std::hypot(halfLength, halfWidth); }
};

/// Forward and counter-clockwise.
struct DriveVelocity {
  double forward = 0;   ///< m/s
  double rotation = 0;  ///< rad/s
  bool operator==(const DriveVelocity&) const = default;
};

/// What a robot on wheels can do.
struct DriveLimits {
  double speed = 0.75, rotation = robotlink::radians(100);                    ///< m/s, rad/s
  double acceleration = 0.3, rotationAcceleration = robotlink::radians(100);  ///< m/s^2, rad/s^2
};

}  // namespace modules
