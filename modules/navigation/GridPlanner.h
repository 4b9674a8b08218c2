// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "modules/navigation/DistanceMap.h"

namespace modules {

/// A path in a map, or the reason why there is none.
struct PlannedPath {
  /// In the map, m, from the robot to the goal; empty if it is blocked.
  std::vector<robotlink::Vector2> points;
  /// The reason why there is no path; empty if there is one.
  std::string reason;
  /// Whether it is longer than it would be without obstacles that the map does not have.
  bool around = false;
  bool blocked() const { return !reason.empty(); }
  /// Meters.
  double length() const;
};

/// Plans paths in a map on a grid: a wave expands from the goal through all free cells (Dijkstra 1959), at a
/// higher cost near walls, so that one wave serves paths from all places. A path descends the wave and is
/// then straightened where that costs no more. Forbidden lines and areas are walls, and so are obstacles that
/// the map does not have. One thread at a time.
class GridPlanner {
 public:
  struct Options {
    /// Meters.
    double cell = 0.1;
    /// The distance from walls that the robot's center needs, m.
    double clearance = 0.32;
    /// The distance from walls beyond which they do not matter, m.
    double comfort = 0.8;
    /// The cost of a meter at the least clearance is higher by this factor.
    double nearness = 3;
    /// The distance from a robot that is too close to a wall at which a path may begin, m.
    double reach = 1.0;
  };
  /// Builds the grid; the map need not outlive it.
  GridPlanner(const robotlink::GroundMap& map, const Options& options);

  /// Computes the wave: some 20 ms for a large building, twice that while there are obstacles. Any goal is
  /// accepted; path() reports if it cannot be reached.
  void setGoal(const robotlink::Vector2& goal);
  /// Sets the places of obstacles that the map does not have, instead of those before; computes the wave
  /// again.
  void setObstacles(std::span<const robotlink::Vector2> places);
  /// The walls of the map, without forbidden lines and areas.
  const DistanceMap& walls() const { return walls_; }
  const std::optional<robotlink::Vector2>& goal() const { return goal_; }
  /// A path from the robot's position, which may be too close to a wall. Needs a goal.
  PlannedPath path(const robotlink::Vector2& from) const;
  /// A place that the wave has reached.
  struct WavePoint {
    robotlink::Vector2 place;
    /// Its cost relative to that of the farthest place, 0 at the goal to 1.
    double share = 0;
  };
  /// Returns at most `most` places that the wave has reached, evenly spread; for drawings.
  std::vector<WavePoint> wave(std::size_t most) const;

 private:
  /// Whether the robot's center can be there.
  bool passable(int column, int row) const;
  bool passable(const robotlink::Vector2& place) const;
  /// The distance from a place to walls, what is forbidden and obstacles, m.
  double clearanceAt(const robotlink::Vector2& place) const;
  /// The wave from the goal at some costs by cell.
  std::vector<float> waveOf(const std::vector<float>& costs) const;
  /// The cost of a meter at a clearance.
  double costOf(double clearance) const;
  /// The cost of a straight path; infinite if it is blocked.
  double costOf(const robotlink::Vector2& from, const robotlink::Vector2& to) const;
  /// Returns why the robot cannot be at the goal; empty if it can.
  std::string wrongWithGoal() const;
  /// The cell where the path of a robot begins on a wave; empty if there is none within reach. Between it and
  /// the robot there is nothing.
  std::optional<std::size_t> startCell(const robotlink::Vector2& from, const std::vector<float>& wave) const;
  bool nothingBetween(const robotlink::Vector2& from, const robotlink::Vector2& to) const;
  /// The centers of the cells from one to the goal.
  std::vector<robotlink::Vector2> downTheWave(std::size_t cell) const;
  /// The path with unnecessary points removed.
  std::vector<robotlink::Vector2> straightened(const std::vector<robotlink::Vector2>& points) const;

  Options options_;
  /// The map without forbidden lines and areas, to tell whether those or walls are in the way.
  DistanceMap walls_;
  /// The map with them.
  DistanceMap obstacles_;
  GridFrame frame_;
  /// The cost of a meter by cell according to the map; infinite where the robot cannot be. costs_: with
  /// obstacles, too.
  std::vector<float> mapCosts_, costs_;
  /// The distance of each cell to the nearest obstacle that the map does not have, m; kFar beyond the
  /// comfort.
  std::vector<float> toObstacle_;
  std::optional<robotlink::Vector2> goal_;
  /// The cost to the goal by cell; infinite where there is no path. mapWave_: by the map alone.
  std::vector<float> mapWave_, wave_;
};

}  // namespace modules
