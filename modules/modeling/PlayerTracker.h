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
  /// Meters.
  robotlink::Vector2 positionInField = robotlink::Vector2::Zero();
  /// From 0 to 1.
  double confidence = 0;
};

/// Tracks other robots: a percept near a known robot of the same team moves it, any other percept adds one;
/// the confidence of robots that are not seen decays. Not thread-safe.
class PlayerTracker {
 public:
  struct Options {
    /// The distance within which a percept is assigned to a known robot, m.
    double sameWithin = 0.4;
    /// Half-life of the confidence, s.
    double halfLife = 2;
    /// Robots with less confidence are removed.
    double forgetBelow = 0.1;
    /// The fraction by which a percept moves a known robot, 0 to 1.
    double pull = 0.4;
    std::size_t maximumPlayers = 7;
  };
  explicit PlayerTracker(const Options& options) : options_(options) {}
  void setOptions(const Options& options) { options_ = options; }

  /// Call it once a frame; `time` in s of any clock.
  void update(double time, std::span<const TrackedPlayer> seen);
  /// Sorted by decreasing confidence.
  const std::vector<TrackedPlayer>& players() const { return players_; }

 private:
  Options options_;
  std::vector<TrackedPlayer> players_;
  double updatedAt_ = 0;
};

}  // namespace modules
