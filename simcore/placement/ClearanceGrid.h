// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "robotlink/base/Geometry.h"

namespace simcore {

/// How far it is to the nearest obstacle from each cell of a floor. Obstacles are marked first; then
/// clearances are worked out once, for all of them. What lies outside of the grid is free.
class ClearanceGrid {
 public:
  struct Cell {
    int x = 0, y = 0;
    bool operator==(const Cell&) const = default;
  };

  /// Cells of `cellSize`, or of more where there would be more than four million of them.
  ClearanceGrid(const robotlink::Vector2& low, const robotlink::Vector2& high, double cellSize);

  int width() const { return width_; }
  int height() const { return height_; }
  double cellSize() const { return cellSize_; }
  bool contains(const Cell& cell) const {
    return cell.x >= 0 && cell.x < width_ && cell.y >= 0 && cell.y < height_;
  }
  std::size_t indexOf(const Cell& cell) const {
    return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(cell.x);
  }
  /// Those of points outside lie outside.
  Cell cellAt(const robotlink::Vector2& point) const;
  robotlink::Vector2 centerOf(const Cell& cell) const;

  /// A rectangle of `size` whose frame is `pose`, and a circle.
  void markRectangle(const robotlink::Pose2& pose, const robotlink::Vector2& size);
  void markCircle(const robotlink::Vector2& center, double radius);
  void mark(const Cell& cell);

  /// Must be called after the last mark.
  void findClearances();
  bool isMarked(const Cell& cell) const { return marks_[indexOf(cell)] != 0; }
  /// From the cell's centre to the centre of the nearest marked cell, m; very much if nothing is marked.
  double clearance(const Cell& cell) const { return static_cast<double>(clearances_[indexOf(cell)]); }

 private:
  void markLarge(const robotlink::Pose2& pose, const robotlink::Vector2& size);

  robotlink::Vector2 low_;
  double cellSize_ = 0;
  int width_ = 0, height_ = 0;
  std::vector<std::uint8_t> marks_;
  std::vector<float> clearances_;
};

}  // namespace simcore
