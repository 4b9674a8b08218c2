// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "robotlink/base/Random.h"
#include "simcore/placement/ClearanceGrid.h"

namespace simcore {

/// The positions at which a round robot can stand on a floor: with enough clearance, enclosed by the
/// building, and reachable. They follow from the clearances and from the initial positions of robots. The
/// grid must outlive it.
class FreeSpace {
 public:
  /// `radius` is the robot's plus the clearance that it needs. With `start`, takes the free cells that can be
  /// reached from there (or from the nearest free cell, if that place is not free); otherwise those of the
  /// largest part of the floor that is closed. If a way leads into the open, only cells with something around
  /// them count. On a floor with nothing around it, every free cell counts.
  FreeSpace(const ClearanceGrid& grid, double radius, std::optional<robotlink::Vector2> start);

  bool empty() const { return cells_.empty(); }
  const std::vector<ClearanceGrid::Cell>& cells() const { return cells_; }

  /// The free position nearest to a point.
  std::optional<robotlink::Vector2> nearest(const robotlink::Vector2& point) const;
  /// A random free position at least `apart` from all in `taken`, preferring positions far from them; empty
  /// if there is none.
  std::optional<robotlink::Vector2> pick(const std::vector<robotlink::Vector2>& taken, double apart,
                                         robotlink::Random& random) const;
  /// A heading that faces as much free space as possible from a place.
  double headingAt(const robotlink::Vector2& place, robotlink::Random& random) const;

 private:
  using Cell = ClearanceGrid::Cell;
  /// A connected part of the floor.
  struct Part;

  bool isFree(const Cell& cell) const { return grid_.contains(cell) && grid_.clearance(cell) >= radius_; }
  std::optional<Cell> freeCellNextTo(const robotlink::Vector2& point) const;
  /// Floods the free cells around `start`.
  Part partAround(const Cell& start, std::vector<std::uint8_t>& visited) const;
  Part largestPart() const;
  /// Drops cells that have nothing around them.
  void keepSurrounded();

  const ClearanceGrid& grid_;
  double radius_ = 0;
  std::vector<Cell> cells_;
};

}  // namespace simcore
