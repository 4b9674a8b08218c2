// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "robotlink/base/Geometry.h"
#include "robotlink/base/GroundMap.h"

namespace modules {

/// How a grid lies in the frame of the map. Cell (0, 0) is at the low corner.
struct GridFrame {
  robotlink::Vector2 low = robotlink::Vector2::Zero();  ///< m, the outer corner of cell (0, 0)
  double cell = 0.05;                                   ///< m, its side
  int width = 0, height = 0;                            ///< cells

  int column(double x) const { return static_cast<int>(std::floor((x - low.x()) / cell)); }
  int row(double y) const { return static_cast<int>(std::floor((y - low.y()) / cell)); }
  bool contains(int column, int row) const {
    return column >= 0 && row >= 0 && column < width && row < height;
  }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
  }
  std::size_t size() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
  robotlink::Vector2 center(int column, int row) const {
    return {low.x() + (column + 0.5) * cell, low.y() + (row + 0.5) * cell};
  }
};

/// How far each place of a map is from the nearest wall, on a grid; made once, immutable then. Distances are
/// those between the middles of cells, exact otherwise (Felzenszwalb and Huttenlocher 2012).
class DistanceMap {
 public:
  struct Options {
    double cell = 0.05;   ///< m; larger where the grid would have too many
    double margin = 1.0;  ///< m, around the walls
    std::size_t mostCells = 4'000'000;
    bool forbidden = false;  ///< forbidden lines and areas are walls, too
  };
  DistanceMap(const robotlink::GroundMap& map, const Options& options);

  const GridFrame& frame() const { return frame_; }
  /// m; `kFar` outside of the grid and where the map has no wall at all.
  double at(const robotlink::Vector2& place) const {
    const int column = frame_.column(place.x()), row = frame_.row(place.y());
    return frame_.contains(column, row) ? distances_[frame_.index(column, row)] : kFar;
  }
  double at(int column, int row) const { return distances_[frame_.index(column, row)]; }
  /// What a sensor there would measure along its heading: the way to the nearest wall in its cone, `maximum`
  /// if there is none. A cone of no width is a ray.
  double range(const robotlink::Pose2& sensor, double openingAngle, double maximum) const;

  static constexpr float kFar = 1e3F;

 private:
  void occupyLine(const robotlink::GroundMap::Line& line);
  void occupyArea(const robotlink::GroundMap::Place& area);
  void occupy(const robotlink::Vector2& place);
  void transform();

  GridFrame frame_;
  std::vector<float> distances_;  // row by row; while it is made squares of cells, 0 where there is a wall
};

}  // namespace modules
