// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>

#include "modules/driving/Outline.h"
#include "modules/driving/PolarView.h"
#include "robotlink/base/Random.h"

namespace modules {

/// Drives around in an environment that it does not know: to where there is room and where it has not been
/// for long, preferably straight ahead, at times with a preference for one side; turns on the spot where
/// there is no way. It records by dead reckoning where it has been, in a bounded number of squares.
/// Deterministic for a seed. Not thread-safe.
class Wanderer {
 public:
  struct Options {
    /// Maximal speeds, m/s and rad/s.
    double speed = 0.45, rotation = 0.8;
    /// Free distance ahead, from the robot's center, below which it turns on the spot, m...
    double room = 0.55;
    /// ...until there is this much, m.
    double roomAgain = 0.9;
    /// Free distance ahead from which it drives at full speed, m.
    double easyRoom = 1.3;
    /// Mean time of a preference for a side, s.
    double likingTime = 12;
    /// A way to new places is worth as much as this additional free distance, m.
    double novelty = 4;
    /// Half the width of the corridor that should be free, m.
    double halfWidth = 0.35;
    std::uint64_t seed = 1;
  };
  explicit Wanderer(const Options& options) : options_(options), random_(options.seed) {}
  /// Takes effect with the next decide(), except for the seed.
  void setOptions(const Options& options) { options_ = options; }

  /// `points` are obstacles in the robot's frame, m; `time` in s of any clock.
  DriveVelocity decide(std::span<const robotlink::Vector2> points, const robotlink::Pose2& robotInOdometry,
                       double time);
  /// The direction that it drives to, in the robot's frame, rad; for drawings.
  double direction() const { return direction_; }

 private:
  /// Counts the time spent in the square of a place.
  void visit(const robotlink::Vector2& place, double time);
  /// How well a place is known: 0 for never visited, toward 1 for often.
  double visited(const robotlink::Vector2& place) const;
  /// The value of a direction as a free distance, m, including that of new places.
  double valueOf(double angle, const PolarView& view, const robotlink::Pose2& robotInOdometry) const;
  /// The direction with the highest value.
  double bestDirection(const PolarView& view, const robotlink::Pose2& robotInOdometry) const;
  /// The side with more value: 1 left, -1 right.
  double betterSide(const PolarView& view, const robotlink::Pose2& robotInOdometry) const;

  Options options_;
  robotlink::Random random_;
  /// The preferred direction, rad.
  double liking_ = 0;
  double likingUntil_ = -1;
  /// 1 or -1 while it turns on the spot.
  double turning_ = 0;
  double direction_ = 0;
  /// The chosen direction in the odometry frame.
  double heading_ = 0;
  /// Time spent in each square, s.
  std::unordered_map<std::uint64_t, double> visits_;
  double visitedAt_ = -1;
};

}  // namespace modules
