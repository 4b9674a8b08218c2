// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace colortool {

/// The cells of a colour table of another size: Y first, then the two chroma channels, the last one fastest.
/// A plain value.
struct CellGrid {
  static constexpr int kMaxCells = 128;  ///< a side

  /// Along Y and the chroma channels in their order here: powers of two from 1 to kMaxCells.
  std::array<int, 3> sides{};
  bool crFirst = false;  ///< Cr before Cb
  std::vector<std::uint8_t> classes;

  static constexpr std::size_t count(const std::array<int, 3>& sides) {
    std::size_t product = 1;
    for (const int side : sides) product *= static_cast<std::size_t>(side);
    return product;
  }
  static bool fits(int side) { return side >= 1 && side <= kMaxCells && (side & (side - 1)) == 0; }
};

/// The same in the cells of a ColorTable.
struct RegriddedCells {
  std::vector<std::uint8_t> classes;
  /// Cells over several of the grid's that are not of one class. They are of the class that most of these
  /// have, with the lowest number if that is true of several; of none only where it is of none most.
  std::size_t mixedCells = 0;
};
/// `grid.classes` must be as many as its sides say.
RegriddedCells regrid(const CellGrid& grid);

}  // namespace colortool
