// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace simcore {

/// Rays from one point in a plane, at equal angles. Immutable.
class RayFan {
 public:
  /// `count` rays (at least one) from angle `start` to angle `end`, rad, counterclockwise, over at most a
  /// full turn.
  RayFan(double start, double end, int count);

  std::size_t size() const { return directions_.size(); }
  double start() const { return start_; }
  /// The angle between neighbors; 0 for a single ray.
  double step() const { return step_; }
  /// Unit vectors in the fan's plane, in the order of the angles.
  const std::vector<Eigen::Vector2d>& directions() const { return directions_; }

 private:
  double start_ = 0, step_ = 0;
  std::vector<Eigen::Vector2d> directions_;
};

/// The hit of one ray of a fan.
struct FanHit {
  /// The maximum if there is no hit.
  double distance = 0;
  /// The cosine of the angle between the ray and the surface's normal.
  double cosIncidence = 1;
};

}  // namespace simcore
