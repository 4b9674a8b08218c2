// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "modules/driving/Outline.h"

namespace modules {

/// The time for which a robot can keep a velocity before an obstacle comes too close to its outline. A point
/// closer than the margin already does not count as long as it does not come closer. A plain value for one
/// set of obstacles.
class Clearance {
 public:
  struct Options {
    /// The distance to keep around the outline, m.
    double margin = 0.1;
    /// The time to look ahead, s.
    double horizon = 3.0;
  };
  /// `points` are obstacles in the robot's frame, m.
  Clearance(const Outline& outline, const Options& options, std::span<const robotlink::Vector2> points);

  /// The time for which the robot can keep this velocity, s; the horizon if nothing is in its way.
  double freeTime(const DriveVelocity& velocity) const;
  /// Whether it can drive like this until the next decision and still brake then. `latency` is the delay
  /// until a request takes effect, s.
  bool safe(const DriveVelocity& velocity, const DriveLimits& limits, double latency) const;
  /// The given velocity, scaled down until it is safe; either its forward speed or its rotation may become 0.
  DriveVelocity limited(const DriveVelocity& velocity, const DriveLimits& limits, double latency) const;
  /// The distance to the nearest obstacle, m; very large if there is none.
  double nearest() const { return nearest_; }
  /// The distance to the nearest obstacle after driving at a velocity for `time` seconds, m.
  double nearestAfter(const DriveVelocity& velocity, double time) const;

 private:
  // Single precision, because many obstacles are checked many times.
  struct Obstacle {
    float x, y;
    /// The least distance allowed, m.
    float allowed;
    /// The distance from the robot's center, m.
    float reach;
  };
  Outline outline_;
  Options options_;
  /// Nearest first.
  std::vector<Obstacle> obstacles_;
  double nearest_ = 1e3;
};

}  // namespace modules
