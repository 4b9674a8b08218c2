// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/driving/Clearance.h"
#include "modules/driving/PolarView.h"

namespace modules {

/// The part of obstacle avoidance for when there is no way ahead, or no room for a requested turn: turns on
/// the spot to the side with more room and keeps to that side until there is a way; if it cannot turn, it
/// moves backward or creeps ahead. Not thread-safe.
class CornerEscape {
 public:
  struct Options {
    /// The time for which a request must be without effect before the escape begins, s.
    double patience = 0.5;
    /// Free distance ahead, from the robot's center, that ends the escape, m.
    double roomAhead = 0.9;
    /// Radians per second.
    double rotation = 0.6;
    /// Meters per second.
    double backingSpeed = 0.12;
    /// Delay until a request takes effect, s.
    double latency = 0.25;
  };
  /// A request with a lower speed is not considered a request to drive, m/s.
  static constexpr double kWantsSpeed = 0.05;

  explicit CornerEscape(const Options& options) : options_(options) {}
  void setOptions(const Options& options) { options_ = options; }

  /// `wish` is the request, `possible` the safe part of it, `time` in s of any clock. Returns the velocity to
  /// drive at.
  DriveVelocity decide(const DriveVelocity& desired, const DriveVelocity& possible,
                       const Clearance& clearance, const PolarView& view, const DriveLimits& limits,
                       double time);
  /// Whether an escape is in progress.
  bool active() const { return side_ != 0; }

 private:
  /// Whether the requested motion is possible again.
  bool freed(const DriveVelocity& desired, const Clearance& clearance, const PolarView& view,
             const DriveLimits& limits) const;
  /// The velocity of the escape.
  DriveVelocity escape(const Clearance& clearance, const DriveLimits& limits, double time);

  Options options_;
  /// Negative if the robot is not stuck.
  double stuckSince_ = -1;
  /// The side to turn to: 1 left, -1 right, 0 no escape.
  double side_ = 0;
  /// The time at which turning to that side began.
  double since_ = 0;
  /// Direction of the last move that was to make room: 1 ahead, -1 back.
  double direction_ = -1;
};

}  // namespace modules
