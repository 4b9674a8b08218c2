// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/base/Clock.h"
#include "robotlink/base/Geometry.h"

namespace modules {

/// One distance that a sensor measured: a laser's ray or a sonar's cone.
struct RangeBeam {
  robotlink::Pose2 sensorInRobot;  ///< it measures along its x-axis
  double range = 0;                ///< m; `maximum` where nothing was hit
  double maximum = 0;              ///< m
  double openingAngle = 0;         ///< rad, of the whole cone; 0: a ray
  robotlink::Instant time;         ///< when it was measured

  bool hit() const { return range < maximum; }
  /// Where the hit lies if it is on the axis, in the robot's frame.
  robotlink::Vector2 endInRobot() const { return sensorInRobot * robotlink::Vector2(range, 0); }
};

}  // namespace modules
