// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Geometry.h"

namespace robotlink::arcos {

/// One sweep of a laser, in SI units and radians. Reading i looks at startAngle + i * angleStep in the
/// laser's frame, counter-clockwise.
struct RangeScan {
  Instant time;  // when its first part came
  Pose2 robot;   // by odometry, when it was made
  Pose2 laserInRobot;
  double startAngle = 0, angleStep = 0;
  std::vector<double> ranges;  // m; kMaximum and more: nothing is there

  static constexpr double kMaximum = 32.0;

  bool echo(std::size_t reading) const { return ranges[reading] > 0 && ranges[reading] < kMaximum; }
  double angle(std::size_t reading) const { return startAngle + angleStep * static_cast<double>(reading); }
  /// In the frame of the robot as it stood when the scan was made.
  Vector2 pointInRobot(std::size_t reading) const {
    return laserInRobot *
           Vector2(ranges[reading] * std::cos(angle(reading)), ranges[reading] * std::sin(angle(reading)));
  }
  bool operator==(const RangeScan&) const = default;
};

}  // namespace robotlink::arcos
