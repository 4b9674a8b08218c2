// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "robotlink/base/Geometry.h"
#include "robotlink/base/GroundMap.h"

namespace modules {

/// The position of a grid in the frame of the map. Cell (0, 0) is at the low corner. A plain value.
struct GridFrame {
  /// The outer corner of cell (0, 0), m.
  robotlink::Vector2 low = robotlink::Vector2::Zero();
  /// Side of a cell, m.
  double cell = 0.05;
  /// Cells.
  int width = 0, height = 0;

  // The cell of a coordinate; may be outside the grid.
  int column(double x) const { return static_cast<int>(std::floor((x - low.x()) / cell)); }
  int row(double y) const { return static_cast<int>(std::floor((y - low.y()) / cell)); }
  bool contains(int column, int row) const {
    return column >= 0 && row >= 0 && column < width && row < height;
  }
  /// Row by row.
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
  }
  std::size_t size() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
  robotlink::Vector2 center(int column, int row) const {
    return {low.x() + (column + 0.5) * cell, low.y() + (row + 0.5) * cell};
  }
};

/// The distance from each place of a map to the nearest wall, on a grid. Built once, then immutable; any
/// thread. Distances are between centers of cells, otherwise exact (Felzenszwalb and Huttenlocher 2012).
class DistanceMap {
 public:
  struct Options {
    /// In m; larger if there would be too many cells.
    double cell = 0.05;
    /// Around the walls, m.
    double margin = 1.0;
    std::size_t mostCells = 4'000'000;
    /// Whether forbidden lines and areas count as walls.
    bool forbidden = false;
  };
  DistanceMap(const robotlink::GroundMap& map, const Options& options);

  const GridFrame& frame() const { return frame_; }
  /// The distance from a place, m; kFar outside the grid and if the map has no walls.
  double at(const robotlink::Vector2& place) const {
    const int column = frame_.column(place.x()), row = frame_.row(place.y());
    return frame_.contains(column, row) ? distances_[frame_.index(column, row)] : kFar;
  }
  double at(int column, int row) const { return distances_[frame_.index(column, row)]; }
  /// The reading of a sensor at a pose: the distance along its heading to the nearest wall in its cone, m;
  /// `maximum` if there is none. A field of view of 0 is a ray.
  double range(const robotlink::Pose2& sensor, double openingAngle, double maximum) const;

  /// Larger than any distance in a map, m.
  static constexpr float kFar = 1e3F;

 private:
  // Mark cells as walls.
  void occupyLine(const robotlink::GroundMap::Line& line);
  void occupyArea(const robotlink::GroundMap::Place& area);
  void occupy(const robotlink::Vector2& place);
  /// Converts the marks to distances.
  void transform();

  GridFrame frame_;
  /// Row by row, m; during construction squares in cells, 0 for walls.
  std::vector<float> distances_;
};

}  // namespace modules
