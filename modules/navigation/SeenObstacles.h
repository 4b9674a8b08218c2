// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "modules/navigation/DistanceMap.h"
#include "modules/navigation/RangeBeam.h"

namespace modules {

/// The places where a laser has recently seen something that the map does not have: a box, a closed door, a
/// standing person. A place counts when some rays have ended there, and does not any more when rays pass
/// it, or when it was not seen for a while. Not thread-safe.
class SeenObstacles {
 public:
  struct Options {
    /// Readings nearer to a wall of the map than this belong to that wall, m.
    double wallDistance = 0.2;
    /// Only rays shorter than this count, m: farther away an error of the heading moves walls.
    double range = 3;
    /// For how long a place counts after it was last seen, s.
    double memory = 60;
    /// The number of rays that must have ended at a place.
    int confirmedBy = 3;
  };
  /// The walls of the map; must outlive it.
  explicit SeenObstacles(const DistanceMap& walls);

  /// Adds rays that were measured at a pose, and forgets what is too old. Cones are ignored. `time` should
  /// not decrease; if it does, everything is forgotten.
  void see(robotlink::Instant time, const robotlink::Pose2& robotInMap, std::span<const RangeBeam> beams,
           const Options& options);
  void clear();

  /// The centers of the places that count, m, in a fixed order.
  std::vector<robotlink::Vector2> places() const;
  /// Changes whenever places() does.
  std::uint64_t generation() const { return generation_; }

 private:
  struct Entry {
    int hits = 0;
    bool counts = false;
    robotlink::Instant seen;
  };
  void end(std::size_t cell, robotlink::Instant time, const Options& options);
  void pass(std::size_t cell);
  /// The cell of a place; the number of cells if there is none.
  std::size_t cellOf(const robotlink::Vector2& place) const;

  const DistanceMap& walls_;
  GridFrame frame_;
  /// Whether a cell has an entry, for a quick look.
  std::vector<bool> marked_;
  /// Keyed by cell; bounded.
  std::map<std::size_t, Entry> entries_;
  robotlink::Instant last_;
  std::uint64_t generation_ = 0;
};

}  // namespace modules
