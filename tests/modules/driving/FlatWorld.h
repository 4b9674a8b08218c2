// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "modules/driving/Outline.h"
#include "robotlink/base/GroundMap.h"

namespace modules {

/// Walls on a plane, computed exactly and without a grid of distances: the reference for the modules. Walls
/// are indexed by squares of one meter, so that large maps are fast enough.
class FlatWorld {
 public:
  /// Points become crosses as wide as the map's resolution.
  explicit FlatWorld(const robotlink::GroundMap& map);

  /// Distance in m along the x-axis of `sensor` to the first wall; `maximum` if there is none.
  double ray(const robotlink::Pose2& sensor, double maximum) const;
  /// The minimum of rays 3 degrees apart.
  double cone(const robotlink::Pose2& sensor, double openingAngle, double maximum) const;
  /// Distance in m from the outline of a robot to the nearest wall; 0 if it touches one, at most 0.5.
  double distance(const Outline& outline, const robotlink::Pose2& robot) const;

 private:
  using Line = robotlink::GroundMap::Line;
  int columnOf(double x) const { return static_cast<int>(std::floor(x - low_.x())); }
  int rowOf(double y) const { return static_cast<int>(std::floor(y - low_.y())); }
  const std::vector<std::size_t>* square(int column, int row) const;
  void add(const Line& line);

  robotlink::Vector2 low_;
  int width_, height_;
  std::vector<Line> lines_;
  /// Indices of lines, by square.
  std::vector<std::vector<std::size_t>> squares_;
};

/// A rectangle of walls from (0, 0) to (length, width), to which others can be added.
robotlink::GroundMap roomMap(double length, double width);
void addWall(robotlink::GroundMap& map, double x1, double y1, double x2, double y2);
/// A map of ../shared/data/arcos; without lines if it is missing.
robotlink::GroundMap sharedMap(const char* name);

}  // namespace modules
