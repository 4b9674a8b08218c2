// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/base/Geometry.h"

namespace modules {

/// A place where the robot sees the edge of a line or the foot of a wall.
struct LineMeasurement {
  /// The position on the ground, in the robot's frame, m.
  robotlink::Vector2 inRobot = robotlink::Vector2::Zero();
  /// The direction of the line in the robot's frame, rad; NaN if unknown.
  double direction = 0;
};

}  // namespace modules
