// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/driving/Clearance.h"
#include "modules/driving/PolarView.h"

namespace modules {

/// What avoiding does where there is no way on, or no room for a turn that is wished: it turns on the spot to
/// the side that has more room, and does not change its mind before there is a way; where it cannot turn, it
/// backs off, or creeps on.
class CornerEscape {
 public:
  struct Options {
    double patience = 0.5;       ///< s, that a wish to drive is without effect before it begins
    double roomAhead = 0.9;      ///< m, free ahead, from the robot's middle, that end it
    double rotation = 0.6;       ///< rad/s
    double backingSpeed = 0.12;  ///< m/s
    double latency = 0.25;       ///< s
  };
  /// m/s; a wish of less is none to drive on.
  static constexpr double kWantsSpeed = 0.05;

  explicit CornerEscape(const Options& options) : options_(options) {}
  void setOptions(const Options& options) { options_ = options; }

  /// `wish`: what is wanted; `possible`: what is safe of it; `time`: s. The velocity to drive at.
  DriveVelocity decide(const DriveVelocity& wish, const DriveVelocity& possible, const Clearance& clearance,
                       const PolarView& view, const DriveLimits& limits, double time);
  bool active() const { return side_ != 0; }

 private:
  /// What the wish wants is possible again.
  bool freed(const DriveVelocity& wish, const Clearance& clearance, const PolarView& view,
             const DriveLimits& limits) const;
  DriveVelocity escape(const Clearance& clearance, const DriveLimits& limits, double time);

  Options options_;
  double stuckSince_ = -1;
  double side_ = 0;  // 1 left, -1 right, 0 none
  double since_ = 0;
  double direction_ = -1;  // of the last move that was to make room
};

}  // namespace modules
