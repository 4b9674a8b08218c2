// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "robotlink/base/Geometry.h"

namespace modules {

/// Another robot on the field.
struct TrackedPlayer {
  std::string team;
  robotlink::Vector2 positionInField = robotlink::Vector2::Zero();  ///< m
  double confidence = 0;                                            ///< 0 to 1
};

/// Keeps the robots that were seen: percepts near a known robot of the same team move it, others add one;
/// what is not seen again fades away.
class PlayerTracker {
 public:
  struct Options {
    double sameWithin = 0.4;  ///< m
    double halfLife = 2;      ///< s
    double forgetBelow = 0.1;
    double pull = 0.4;  ///< how far a percept moves a known robot, 0 to 1
    std::size_t maximumPlayers = 7;
  };
  explicit PlayerTracker(const Options& options) : options_(options) {}
  void setOptions(const Options& options) { options_ = options; }

  void update(double time, std::span<const TrackedPlayer> seen);
  /// Surest first.
  const std::vector<TrackedPlayer>& players() const { return players_; }

 private:
  Options options_;
  std::vector<TrackedPlayer> players_;
  double updatedAt_ = 0;
};

}  // namespace modules
