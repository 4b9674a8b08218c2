// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "robotlink/base/Geometry.h"

namespace simcore {

/// The distance from each cell of a floor to the nearest obstacle. First mark the obstacles, then compute all
/// clearances at once. The outside of the grid is free. Meters, in the frame of the world. Not thread-safe
/// while it is being filled.
class ClearanceGrid {
 public:
  /// Indices of a cell; may be outside the grid.
  struct Cell {
    int x = 0, y = 0;
    bool operator==(const Cell&) const = default;
  };

  /// Covers the rectangle from `low` to `high` with cells of `cellSize`, or larger ones if there would be
  /// more than four million of them.
  ClearanceGrid(const robotlink::Vector2& low, const robotlink::Vector2& high, double cellSize);

  int width() const { return width_; }
  int height() const { return height_; }
  double cellSize() const { return cellSize_; }
  bool contains(const Cell& cell) const {
    return cell.x >= 0 && cell.x < width_ && cell.y >= 0 && cell.y < height_;
  }
  /// Row by row, from low to high.
  std::size_t indexOf(const Cell& cell) const {
    return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(cell.x);
  }
  /// The cell of a point; outside the grid if the point is.
  Cell cellAt(const robotlink::Vector2& point) const;
  robotlink::Vector2 centerOf(const Cell& cell) const;

  /// Marks the cells of a rectangle of `size` centered in the frame `pose`, or those of a circle.
  void markRectangle(const robotlink::Pose2& pose, const robotlink::Vector2& size);
  void markCircle(const robotlink::Vector2& center, double radius);
  void mark(const Cell& cell);

  /// Computes the clearances; call it after the last mark.
  void findClearances();
  bool isMarked(const Cell& cell) const { return marks_[indexOf(cell)] != 0; }
  /// The distance from the cell's center to that of the nearest marked cell, m; very large if nothing is
  /// marked.
  double clearance(const Cell& cell) const { return static_cast<double>(clearances_[indexOf(cell)]); }

 private:
  /// Marks a rectangle that is large compared to a cell.
  void markLarge(const robotlink::Pose2& pose, const robotlink::Vector2& size);

  robotlink::Vector2 low_;
  double cellSize_ = 0;
  int width_ = 0, height_ = 0;
  /// Indexed by cell; not 0 means an obstacle.
  std::vector<std::uint8_t> marks_;
  /// Indexed by cell, m.
  std::vector<float> clearances_;
};

}  // namespace simcore
