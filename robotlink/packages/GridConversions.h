// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>

#include "robotlink/base/Error.h"
#include "robotlink/base/GroundMap.h"

namespace foxglove {
class Grid;
}

namespace robotlink {

/// A rectangle of cells in one row of an occupancy grid, in meters in the grid's own frame.
struct GridRun {
  /// The corner with the lowest coordinates, m.
  Vector2 low = Vector2::Zero();
  /// Along x and along y, m.
  double length = 0, width = 0;
};

/// Calls `use` for the runs of occupied cells (50 to 100 percent) of each row, until it returns false. A
/// message whose strides, sizes or fields do not fit its data has no runs.
void forOccupiedRuns(const foxglove::Grid& grid, const std::function<bool(const GridRun&)>& use);

/// Makes a map of the occupied cells of an occupancy grid: a point in the center of each one, and the size of
/// a cell as resolution, so that neighboring cells are a wall. Fails if the grid has no occupied cell
/// (map.empty), or more than a file of a map may have (map.too-large).
Result<GroundMap> groundMap(const foxglove::Grid& grid);

}  // namespace robotlink
