// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "modules/driving/Outline.h"

namespace modules {

/// How long a robot may drive until it comes too near to what is around it, by its real outline. A point that
/// is nearer than the margin already is no hindrance as long as the robot gets no nearer to it.
class Clearance {
 public:
  struct Options {
    double margin = 0.1;   ///< m, that shall stay free around the outline
    double horizon = 3.0;  ///< s, looked ahead
  };
  /// `points`: obstacles in the robot's frame.
  Clearance(const Outline& outline, const Options& options, std::span<const robotlink::Vector2> points);

  /// s, for which the robot may keep this velocity; the horizon if nothing is in its way.
  double freeTime(const DriveVelocity& velocity) const;
  /// Whether it may drive so until the next decision, and still brake then. `latency`: s, until a request
  /// acts.
  bool safe(const DriveVelocity& velocity, const DriveLimits& limits, double latency) const;
  /// The velocity, or as much of it as is safe; of forward and backward speed and rotation either may be 0
  /// then.
  DriveVelocity limited(const DriveVelocity& velocity, const DriveLimits& limits, double latency) const;
  /// m, to what is nearest; the horizon's reach if there is nothing.
  double nearest() const { return nearest_; }
  /// m, to what will be nearest after some seconds of a velocity.
  double nearestAfter(const DriveVelocity& velocity, double time) const;

 private:
  struct Obstacle {
    float x, y;
    float allowed;  // m, as near as it may come
    float reach;    // m, from the robot's middle
  };
  Outline outline_;
  Options options_;
  std::vector<Obstacle> obstacles_;  // the nearest first
  double nearest_ = 1e3;
};

}  // namespace modules
