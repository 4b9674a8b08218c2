// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "modules/driving/Clearance.h"
#include "modules/driving/CornerEscape.h"
#include "modules/driving/PolarView.h"

namespace modules {

/// What an avoidance is told, all in the robot's frame.
struct AvoidanceSituation {
  DriveVelocity wish;
  DriveVelocity now;  ///< as the wheels turn
  std::span<const robotlink::Vector2> points;
  DriveLimits limits;
  double time = 0;  ///< s
};

/// Avoids obstacles by a polar histogram (the vector field histogram of Borenstein and Koren 1991, with the
/// widening by the robot's size and the costs of Ulrich and Borenstein 1998): of the directions in which
/// there is a way it takes the one that is cheapest by how far it is from the wish, from straight on and from
/// the last one. What comes out is held against the robot's outline, and is never more than it can still
/// brake from.
class VectorField {
 public:
  struct Options {
    Outline outline;
    double margin = 0.12;    ///< m, beside the robot, that a way must have
    double reach = 2.5;      ///< m, that is looked at
    double need = 1.0;       ///< m, from the robot's middle, that makes a direction open; ...
    double needAgain = 1.2;  ///< m, ... one that was closed needs more
    double wishTime = 1.0;   ///< s, after which a wish to turn would have the direction that is wanted
    double wishCost = 5, straightCost = 1.5, lastCost = 2;  ///< of a radian
    double steering = 1.5;                                  ///< 1/s
    double latency = 0.25;                                  ///< s
    CornerEscape::Options escape;
  };
  explicit VectorField(const Options& options) : options_(options), escape_(options.escape) {}
  void setOptions(const Options& options);

  DriveVelocity decide(const AvoidanceSituation& situation);
  // For drawings.
  bool open(int sector) const { return open_[static_cast<std::size_t>(PolarView::wrapped(sector))]; }
  const PolarView& view() const { return view_; }
  double direction() const { return direction_; }  ///< rad, that was chosen
  bool escaping() const { return escape_.active(); }

 private:
  void openSectors(double need);
  /// Steers the wish through the histogram.
  DriveVelocity steered(const DriveVelocity& wish, const DriveLimits& limits);

  Options options_;
  CornerEscape escape_;
  PolarView view_{{}, 0.3, 2.5};
  std::array<bool, PolarView::kSectors> open_{};
  double direction_ = 0;
};

}  // namespace modules
