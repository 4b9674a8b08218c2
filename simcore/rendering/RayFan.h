// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace simcore {

/// Rays from one point in a plane, equally far apart in angle.
class RayFan {
 public:
  /// `count` rays from angle `start` to angle `end`, rad, counter-clockwise; at least one, and at most a full
  /// turn.
  RayFan(double start, double end, int count);

  std::size_t size() const { return directions_.size(); }
  double start() const { return start_; }
  double step() const { return step_; }  ///< between two neighbours; 0 if there is one ray alone
  const std::vector<Eigen::Vector2d>& directions() const { return directions_; }

 private:
  double start_ = 0, step_ = 0;
  std::vector<Eigen::Vector2d> directions_;
};

/// What a ray of a fan meets.
struct FanHit {
  double distance = 0;      ///< the maximum if it meets nothing
  double cosIncidence = 1;  ///< of the angle between the ray and the surface's normal
};

}  // namespace simcore
