// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "colortool/ColorTable.h"

namespace colortool {

/// Any cells of a colour table, a bit each: rows of 64 cells along Cr, so that what is done to all cells is
/// done to a row at a time. A plain value of 32 KB.
class CellSet {
 public:
  using Row = std::uint64_t;                       ///< bit i: the cell with Cr i
  static constexpr std::size_t kRows = 64U * 64U;  ///< row y * 64 + cb

  bool contains(std::size_t cell) const { return (rows_[cell / 64] >> (cell % 64) & 1U) != 0; }
  void set(std::size_t cell, bool in = true) {
    const Row bit = Row{1} << (cell % 64);
    rows_[cell / 64] = in ? rows_[cell / 64] | bit : rows_[cell / 64] & ~bit;
  }
  Row row(std::size_t index) const { return rows_[index]; }
  Row& row(std::size_t index) { return rows_[index]; }

  bool empty() const {
    return std::ranges::all_of(rows_, [](Row row) { return row == 0; });
  }
  std::size_t size() const;
  bool operator==(const CellSet&) const = default;

 private:
  std::array<Row, kRows> rows_{};
};

/// Which cells are next to each other: those that share a face, or those that share at least a corner.
enum class CellNeighbors : std::uint8_t { k6, k26 };

/// All cells of `within` that are connected, inside of it, with one of `seeds` that is in it. The order of
/// 0.1 ms for the whole cube.
CellSet connectedCells(const CellSet& seeds, const CellSet& within, CellNeighbors neighbors);
/// The cells that have one of `cells` as a neighbour by a face; some of them may be of `cells` themselves.
CellSet facesOf(const CellSet& cells);

}  // namespace colortool
