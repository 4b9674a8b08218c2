// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "modules/modeling/PlayerTracker.h"
#include "modules/modeling/players/PlayerSight.h"

namespace modules {

/// A grid over the field for each team that says where its robots may be (certainty grids; Moravec, Elfes
/// 1985), as the GermanTeam modeled players. A percept adds evidence around its place, the wider the farther
/// away it is; evidence fades with time, and much faster where the robot looks and sees nobody. Players are
/// the peaks of the grid. No percept has to be assigned to a player. Not thread-safe.
class PlayerGrid {
 public:
  struct Options {
    /// Deviation of a percept's place, m, plus this for each meter of distance.
    double deviationNear = 0.08, deviationPerMeter = 0.12;
    /// Half-life of evidence, s: where nobody looks, and where the robot looks and sees nobody.
    double halfLife = 3, seenHalfLife = 0.7;
    /// Evidence of a peak, 0 to 1.
    double minimumPeak = 0.15;
    /// Peaks of a team nearer to each other are the same robot, m.
    double apart = 0.4;
    int maximumPlayers = 4;
  };
  /// The side of a cell, m.
  static constexpr double kCell = 0.1;

  /// A grid over a field of this size, m; robots may stand somewhat outside.
  PlayerGrid(double length, double width, const Options& options);
  void setOptions(const Options& options) { options_ = options; }

  /// Call it once a frame.
  void update(const PlayerFrame& frame);
  /// Sorted by decreasing confidence.
  const std::vector<TrackedPlayer>& players() const { return players_; }

  /// A cell of a team and its evidence; for drawings.
  struct Cell {
    std::string team;
    robotlink::Vector2 center = robotlink::Vector2::Zero();
    double evidence = 0;
  };
  /// The cells with more evidence than this.
  std::vector<Cell> cells(double minimum) const;

 private:
  struct Layer {
    std::string team;
    std::vector<double> evidence;
  };
  robotlink::Vector2 center(int column, int row) const;
  Layer& layerOf(const std::string& team);
  void fade(const SeenSector& sector, double seconds);
  void add(const PlayerSight& sight, const PlayerFrame& frame);
  void findPeaks();
  /// Adds the peak at a cell, if it is one.
  void addPeak(const Layer& layer, int column, int row, std::vector<TrackedPlayer>& peaks) const;

  Options options_;
  robotlink::Vector2 origin_;
  int columns_, rows_;
  std::vector<Layer> layers_;
  std::vector<TrackedPlayer> players_;
  double updatedAt_ = 0;
  bool began_ = false;
};

}  // namespace modules
