// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Geometry.h"

namespace robotlink::arcos {

/// A sweep of a laser, in SI units and radians. Reading i is in the direction startAngle + i * angleStep in
/// the laser's frame, counterclockwise. A plain value.
struct RangeScan {
  /// When its first part arrived.
  Instant time;
  /// The robot's pose by odometry at that time.
  Pose2 robot;
  Pose2 laserInRobot;
  double startAngle = 0, angleStep = 0;
  std::vector<double> ranges;  ///< m; kMax or more if there is nothing

  static constexpr double kMax = 32.0;

  /// Whether reading i hit something.
  bool echo(std::size_t reading) const { return ranges[reading] > 0 && ranges[reading] < kMax; }
  double angle(std::size_t reading) const { return startAngle + angleStep * static_cast<double>(reading); }
  /// The hit point in the robot's frame at the time of the scan.
  Vector2 pointInRobot(std::size_t reading) const {
    return laserInRobot *
           Vector2(ranges[reading] * std::cos(angle(reading)), ranges[reading] * std::sin(angle(reading)));
  }
  bool operator==(const RangeScan&) const = default;
};

}  // namespace robotlink::arcos
