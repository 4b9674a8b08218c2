// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "modules/mapping/OccupancyMap.h"

namespace modules {

/// Finds the pose at which a scan fits best to the map so far, near a pose that was predicted. It tries all
/// poses of a window, whose score is how near to occupied cells the rays end (correlative scan matching;
/// Olson 2009), and then refines the best one in smaller and smaller steps. Where the map says nothing of a
/// direction, as along a corridor, the prediction counts. Not thread-safe.
class ScanMatcher {
 public:
  struct Options {
    /// The number of rays that are used, evenly spread.
    int rays = 120;
    /// The distance from the prediction up to which poses are tried, m and rad.
    double reach = 0.25, turnReach = 0.12;
    /// The standard deviation of the ends of rays, m.
    double deviation = 0.06;
    /// The decrease of the score at the border of the window, 0 to 1.
    double trust = 0.1;
    /// The score from which on a match is accepted, 0 to 1.
    double leastScore = 0.35;
  };
  struct Match {
    robotlink::Pose2 robotInMap;
    /// The mean over the rays, 1: each ends at something that is on the map.
    double score = 0;
    /// Whether it counts; otherwise the pose is the predicted one.
    bool accepted = false;
  };

  /// Matches with the map as of the last follow(). Rays that hit nothing are not used; without at least ten
  /// others nothing is accepted.
  Match match(const robotlink::Pose2& predicted, std::span<const RangeBeam> beams, const Options& options);
  /// Takes over what the map's last insert() has changed; call this after each one.
  void follow(const OccupancyMap& map, const Options& options);

 private:
  /// A difference of poses, in units of the search: cells of cell size, and angles.
  struct Offset {
    double x = 0, y = 0, turn = 0;
  };
  /// Scores a pose by the field at the ends of rays; `smooth` interpolates between cells.
  double score(const robotlink::Pose2& pose, bool smooth) const;
  double penalty(const Offset& offset, const Options& options) const;
  Match bestInWindow(const robotlink::Pose2& predicted, const Options& options) const;
  void refine(Match& match, const robotlink::Pose2& predicted, const Options& options) const;
  float fieldAt(int column, int row) const {
    return frame_.contains(column, row) ? field_[frame_.index(column, row)] : 0.0F;
  }
  /// Raises the field around an occupied cell.
  void stamp(int column, int row);
  /// Recomputes the field around a cell that is no longer occupied.
  void renew(const OccupancyMap& map, int column, int row);
  void makeKernel(const Options& options);

  /// The map's frame as of the last follow().
  GridFrame frame_;
  /// The closeness of each cell to an occupied one, 0 to 1.
  std::vector<float> field_;
  /// The values around an occupied cell, a square of 2 * radius_ + 1.
  std::vector<float> kernel_;
  int radius_ = 0;
  double kernelDeviation_ = 0;
  /// The ends of the rays of the present scan, in the robot's frame.
  std::vector<robotlink::Vector2> ends_;
};

}  // namespace modules
