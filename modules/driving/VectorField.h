// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "modules/driving/Clearance.h"
#include "modules/driving/CornerEscape.h"
#include "modules/driving/PolarView.h"

namespace modules {

/// The input of obstacle avoidance, all in the robot's frame.
struct AvoidanceSituation {
  /// The requested velocity.
  DriveVelocity desired;
  /// The velocity measured by the wheels.
  DriveVelocity now;
  /// Obstacles, m.
  std::span<const robotlink::Vector2> points;
  DriveLimits limits;
  /// The present time by any clock, s.
  double time = 0;
};

/// Avoids obstacles with a polar histogram (the vector field histogram of Borenstein and Koren 1991, with the
/// enlargement by the robot's size and the costs of Ulrich and Borenstein 1998). Of the directions with a
/// free way it takes the one with the lowest cost, by its difference from the request, from straight ahead
/// and from the last direction. The result is checked against the robot's outline, and never exceeds a
/// velocity from which it can still brake. Not thread-safe.
class VectorField {
 public:
  struct Options {
    Outline outline;
    /// Clearance of a way on both sides, m.
    double margin = 0.12;
    /// The distance up to which obstacles count, m.
    double reach = 2.5;
    /// Free distance, from the robot's center, that makes a direction open, m.
    double need = 1.0;
    /// Free distance that opens a direction again which was closed, m; it is larger, as hysteresis.
    double needAgain = 1.2;
    /// A requested rotation means the direction that it would reach after this time, s.
    double desiredTime = 1.0;
    /// Costs per radian.
    double desiredCost = 5, straightCost = 1.5, lastCost = 2;
    /// Rotation per difference in direction, 1/s.
    double steering = 1.5;
    /// Delay until a request takes effect, s.
    double latency = 0.25;
    CornerEscape::Options escape;
  };
  explicit VectorField(const Options& options) : options_(options), escape_(options.escape) {}
  void setOptions(const Options& options);

  /// The velocity to drive at; call it once a frame.
  DriveVelocity decide(const AvoidanceSituation& situation);
  // Only for drawings, as of the last decide().
  bool open(int sector) const { return open_[static_cast<std::size_t>(PolarView::wrapped(sector))]; }
  const PolarView& view() const { return view_; }
  /// The direction that was chosen, rad.
  double direction() const { return direction_; }
  bool escaping() const { return escape_.active(); }

 private:
  /// Updates open_, with hysteresis.
  void openSectors(double need);
  /// The velocity that follows the request through the histogram.
  DriveVelocity steered(const DriveVelocity& desired, const DriveLimits& limits);

  Options options_;
  CornerEscape escape_;
  PolarView view_{{}, 0.3, 2.5};
  std::array<bool, PolarView::kSectors> open_{};
  double direction_ = 0;
};

}  // namespace modules
