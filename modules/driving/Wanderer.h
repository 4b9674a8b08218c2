// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>

#include "modules/driving/Outline.h"
#include "modules/driving/PolarView.h"
#include "robotlink/base/Random.h"

namespace modules {

/// Drives about by what is seen around the robot: to where there is room and where it has not been for long,
/// rather straight on than about, now and then with a liking for one side; turns on the spot where there is
/// no way on. Where it has been it knows by dead reckoning, square by square, bounded. Deterministic by its
/// seed.
class Wanderer {
 public:
  struct Options {
    double speed = 0.45, rotation = 0.8;  ///< m/s, rad/s
    double room = 0.55;      ///< m, free ahead, from the robot's middle, below which it turns on the spot ...
    double roomAgain = 0.9;  ///< m, ... until there is so much
    double easyRoom = 1.3;   ///< m, free ahead, from which on it drives at full speed
    double likingTime = 12;  ///< s, that it likes a side for
    double novelty = 4;      ///< m of room that a way to where it never was is worth
    double halfWidth = 0.35;  ///< m, of the way that it wants free
    std::uint64_t seed = 1;
  };
  explicit Wanderer(const Options& options) : options_(options), random_(options.seed) {}
  /// From now on; the seed stays.
  void setOptions(const Options& options) { options_ = options; }

  /// `points`: obstacles in the robot's frame. `time`: s.
  DriveVelocity decide(std::span<const robotlink::Vector2> points, const robotlink::Pose2& robotInOdometry,
                       double time);
  /// The odometry was set to another place.
  void forgetPlaces() { visits_.clear(); }
  /// Where it wants to go, in the robot's frame; for drawings.
  double direction() const { return direction_; }

 private:
  void visit(const robotlink::Vector2& place, double time);
  /// 0: never, to 1: again and again.
  double visited(const robotlink::Vector2& place) const;
  /// m of room, and what new places on the way are worth.
  double valueOf(double angle, const PolarView& view, const robotlink::Pose2& robotInOdometry) const;
  double bestDirection(const PolarView& view, const robotlink::Pose2& robotInOdometry) const;
  double betterSide(const PolarView& view, const robotlink::Pose2& robotInOdometry) const;

  Options options_;
  robotlink::Random random_;
  double liking_ = 0;  // rad, a direction that it likes
  double likingUntil_ = -1;
  double turning_ = 0;  // 1 or -1 while it turns on the spot
  double direction_ = 0;
  double heading_ = 0;                                // in odometry, of the direction
  std::unordered_map<std::uint64_t, double> visits_;  // s spent in each square
  double visitedAt_ = -1;
};

}  // namespace modules
