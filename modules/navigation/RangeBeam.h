// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/base/Clock.h"
#include "robotlink/base/Geometry.h"

namespace modules {

/// A single measured distance: the ray of a laser or the cone of a sonar.
struct RangeBeam {
  /// The pose of the sensor, which measures along its x-axis.
  robotlink::Pose2 sensorInRobot;
  double range = 0;  ///< m; `maximum` if nothing was hit
  /// Meters.
  double maximum = 0;
  /// The full cone, rad; 0 for a ray.
  double openingAngle = 0;
  /// The time at which it was measured.
  robotlink::Instant time;

  bool hit() const { return range < maximum; }
  /// The position of the hit, assuming it is on the axis, in the robot's frame.
  robotlink::Vector2 endInRobot() const { return sensorInRobot * robotlink::Vector2(range, 0); }
};

}  // namespace modules
