// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace colortool {

/// The cells of a color table of another team, whose sides may differ from ours: one class per cell, ordered
/// by Y first, then the two chroma channels, the last one fastest. A plain value.
struct CellGrid {
  static constexpr int kMaxCells = 128;  ///< a side

  /// Along Y and the chroma channels in their order here: powers of two from 1 to kMaxCells.
  std::array<int, 3> sides{};
  /// Whether Cr comes before Cb.
  bool crFirst = false;
  /// The class numbers of all cells; count(sides) of them.
  std::vector<std::uint8_t> classes;

  /// The number of cells of a grid.
  static constexpr std::size_t count(const std::array<int, 3>& sides) {
    std::size_t product = 1;
    for (const int side : sides) product *= static_cast<std::size_t>(side);
    return product;
  }
  static bool fits(int side) { return side >= 1 && side <= kMaxCells && (side & (side - 1)) == 0; }
};

/// A grid converted to the 64 x 64 x 64 cells of a ColorTable.
struct RegriddedCells {
  /// Class numbers in the order of ColorTable::cells().
  std::vector<std::uint8_t> classes;
  /// Number of cells that cover several cells of the grid with different classes. Such a cell gets the most
  /// frequent of these classes. In a tie, "none" loses; among other classes the lowest number wins.
  std::size_t mixedCells = 0;
};
/// Converts a grid. `grid.classes` must hold exactly CellGrid::count(grid.sides) classes. A grid with coarser
/// cells than a ColorTable is repeated, a finer one is reduced by majority.
RegriddedCells regrid(const CellGrid& grid);

}  // namespace colortool
