// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "robotlink/base/Random.h"
#include "simcore/placement/ClearanceGrid.h"

namespace simcore {

/// The places of a floor on which a round robot can stand: with room around it, inside of what surrounds the
/// floor, and reachable. Which these are follows from the clearances and from where robots start.
class FreeSpace {
 public:
  /// `radius` is that of the robot with the room that it needs. With `start`, the free cells that can be
  /// reached from there (or, if nothing is free there, from the free cell next to it); else, those of the
  /// largest part of the floor that nothing leads out of. Where the way leads out into the open, cells must
  /// have something around them. On a floor without anything around it every free cell counts.
  FreeSpace(const ClearanceGrid& grid, double radius, std::optional<robotlink::Vector2> start);

  bool empty() const { return cells_.empty(); }
  double area() const;
  const std::vector<ClearanceGrid::Cell>& cells() const { return cells_; }

  /// The free place next to a point.
  std::optional<robotlink::Vector2> nearest(const robotlink::Vector2& point) const;
  /// A random free place at least `apart` from all in `taken`, far from them rather than near; none if there
  /// is none.
  std::optional<robotlink::Vector2> pick(const std::vector<robotlink::Vector2>& taken, double apart,
                                         robotlink::Random& random) const;
  /// A heading at a place that faces as free a way as there is.
  double headingAt(const robotlink::Vector2& place, robotlink::Random& random) const;

 private:
  using Cell = ClearanceGrid::Cell;
  struct Part;

  bool isFree(const Cell& cell) const { return grid_.contains(cell) && grid_.clearance(cell) >= radius_; }
  std::optional<Cell> freeCellNextTo(const robotlink::Vector2& point) const;
  Part partAround(const Cell& start, std::vector<std::uint8_t>& visited) const;
  Part largestPart() const;
  void keepSurrounded();

  const ClearanceGrid& grid_;
  double radius_ = 0;
  std::vector<Cell> cells_;
};

}  // namespace simcore
