// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "colortool/table/CellSet.h"
#include "widgets/color/space/ColorLattice.h"

namespace widgets {

/// A side of a cell that borders on a cell of another class, or of none.
struct SurfaceFace {
  /// Corners of the lattice, counterclockwise as seen from outside.
  std::array<std::uint32_t, 4> corners;
  /// Outwards, of length 1; averaged over the adjacent faces.
  Eigen::Vector3f normal;
  /// The cell, and its class.
  std::uint32_t cell = 0;
  std::uint8_t colorClass = 0;
};

/// The surfaces of a table's classes. `classes`: by ColorTable::cellOf. `visible`: all other cells count as
/// having no class. Takes about 2 ms for a table of a field's colors.
std::vector<SurfaceFace> surfacesOf(std::span<const std::uint8_t, colortool::ColorTable::kCellCount> classes,
                                    const colortool::CellSet& visible, const ColorLattice& lattice);

}  // namespace widgets
