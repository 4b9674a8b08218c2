// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "colortool/CellSet.h"
#include "widgets/color/ColorLattice.h"

namespace widgets {

/// A side of a cell behind which there is another class, or none.
struct SurfaceFace {
  std::array<std::uint32_t, 4> corners;  ///< of the lattice; seen from outside, counter-clockwise
  Eigen::Vector3f normal;                ///< outwards, of length 1; evened out over the faces around
  std::uint32_t cell = 0;
  std::uint8_t colorClass = 0;
};

/// The surfaces of a table's classes. `classes`: by ColorTable::cellOf; `visible`: the cells that count, all
/// others are as if they were of none. Some 2 ms for a table of a field's colours.
std::vector<SurfaceFace> surfacesOf(std::span<const std::uint8_t, colortool::ColorTable::kCellCount> classes,
                                    const colortool::CellSet& visible, const ColorLattice& lattice);

}  // namespace widgets
