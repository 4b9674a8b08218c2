// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "modules/navigation/DistanceMap.h"
#include "modules/navigation/RangeBeam.h"

namespace modules {

/// A grid that says of each place how likely something is there, from the rays of a laser: places where rays
/// end become more likely, those that rays pass become less likely (Moravec and Elfes 1985; the logarithms of
/// odds are sums as in Thrun, Burgard and Fox, Probabilistic Robotics, 9.2). It grows as it is needed. Not
/// thread-safe.
class OccupancyMap {
 public:
  struct Options {
    /// Side of a cell, m; fixed when the map is made.
    double cell = 0.05;
    /// The logarithms of odds that the end of a ray adds, and that a passing ray takes away.
    double hit = 0.9, miss = 0.4;
    /// The largest logarithm of odds of either sign, so that what moved away is forgotten.
    double limit = 4;
    /// A ray clears places up to this distance from its sensor, m; beyond it only its end counts.
    double clearTo = 12;
    /// A map stops growing before it would be larger.
    std::size_t mostCells = 4'000'000;
  };
  explicit OccupancyMap(const Options& options);
  /// Takes effect from the next scan on, except for the size of cells.
  void setOptions(const Options& options);

  /// Adds rays that were measured at a pose, each cell at most once for all of them: where one ray ends,
  /// others of the same scan do not clear. Cones are ignored. Returns false if the map has reached its limit
  /// and some of the rays lie beyond it.
  bool insert(const robotlink::Pose2& robotInMap, std::span<const RangeBeam> beams);

  const GridFrame& frame() const { return frame_; }
  /// Whether something is there, at more than even odds.
  bool occupied(int column, int row) const {
    return frame_.contains(column, row) && logOdds_[frame_.index(column, row)] > 0;
  }
  /// The probability that something is there in percent; -1 if it has never been seen. The cell must be in
  /// the frame.
  int percent(int column, int row) const;
  /// The number of changes of occupied() for some cell, or of the frame for all.
  std::uint64_t generation() const { return generation_; }

  /// A cell of which occupied() has changed.
  struct Cell {
    int column = 0, row = 0;
  };
  /// The cells that changed in the last insert(); if it changed the frame, these are in the new one.
  std::span<const Cell> changes() const { return changes_; }

 private:
  /// Marks a cell that was never seen; others are in units of kUnit.
  static constexpr std::int16_t kUnseen = INT16_MIN;
  static constexpr double kUnit = 0.01;

  /// Makes room for a place and some more around it. Returns false if the map would become too large.
  bool makeRoom(const robotlink::Vector2& place);
  void clearAlong(const robotlink::Vector2& from, const robotlink::Vector2& to);
  /// Adds to the odds of a cell unless this scan already did.
  void add(const robotlink::Vector2& place, double logOdds);

  Options options_;
  GridFrame frame_;
  /// Row by row.
  std::vector<std::int16_t> logOdds_;
  /// The number of the scan that last changed each cell.
  std::vector<std::uint32_t> changedBy_;
  std::uint32_t scan_ = 0;
  std::uint64_t generation_ = 0;
  std::vector<Cell> changes_;
};

}  // namespace modules
