// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "modules/navigation/DistanceMap.h"

namespace modules {

/// A way in a map, or why there is none.
struct PlannedPath {
  std::vector<robotlink::Vector2>
      points;          ///< in the map, m; from the robot to the goal; empty if it is blocked
  std::string reason;  ///< why there is no way; empty if there is one
  bool blocked() const { return !reason.empty(); }
  double length() const;  ///< m
};

/// Plans ways in a map on a grid: a wave runs from the goal through all that is free (Dijkstra 1959), dearer
/// near walls, so that one wave serves the ways from every place; a way runs down the wave and is then
/// straightened where that costs no more. Forbidden lines and areas are walls. One thread at a time.
class GridPlanner {
 public:
  struct Options {
    double cell = 0.1;        ///< m
    double clearance = 0.32;  ///< m, that the robot's middle needs
    double comfort = 0.8;     ///< m, from walls from which on they do not matter
    double nearness = 3;      ///< how much dearer a metre is at the least clearance
    double reach = 1.0;       ///< m, within which a robot too near to a wall may find to where it can plan
  };
  GridPlanner(const robotlink::GroundMap& map, const Options& options);

  /// Runs the wave: some 20 ms in a large building. The goal may be anywhere; `path` tells if it cannot be
  /// reached.
  void setGoal(const robotlink::Vector2& goal);
  const std::optional<robotlink::Vector2>& goal() const { return goal_; }
  /// Needs a goal. A way from where the robot is, which may be too near to a wall.
  PlannedPath path(const robotlink::Vector2& from) const;
  struct WavePoint {
    robotlink::Vector2 place;
    double share = 0;  ///< of the farthest place's cost, 0 at the goal to 1
  };
  /// Places that the wave reached, evenly spread; for drawings.
  std::vector<WavePoint> wave(std::size_t most) const;

 private:
  bool passable(int column, int row) const;
  bool passable(const robotlink::Vector2& place) const;
  double costOf(double clearance) const;
  /// The cost of a straight path; infinite where it is blocked.
  double costOf(const robotlink::Vector2& from, const robotlink::Vector2& to) const;
  /// Why the goal cannot be stood on; empty if it can.
  std::string wrongWithGoal() const;
  std::optional<std::size_t> startCell(const robotlink::Vector2& from) const;
  std::vector<robotlink::Vector2> downTheWave(std::size_t cell) const;
  std::vector<robotlink::Vector2> straightened(const std::vector<robotlink::Vector2>& points) const;

  Options options_;
  DistanceMap walls_;      // without what is forbidden, to tell which of the two is in the way
  DistanceMap obstacles_;  // with it
  GridFrame frame_;
  std::vector<float> costs_;  // of a metre, by cell; infinite where the robot cannot be
  std::optional<robotlink::Vector2> goal_;
  std::vector<float> wave_;  // cost to the goal; infinite where there is no way
};

}  // namespace modules
