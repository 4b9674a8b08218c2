// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "colortool/table/ColorTable.h"

namespace colortool {

/// A set of cells of a color table with one bit per cell, stored as rows of 64 cells along Cr, so that set
/// operations work on a row at a time. A plain value of 32 KB. Cells are numbered as by ColorTable::cellOf().
class CellSet {
 public:
  /// A row of cells; bit i is the cell with Cr = i.
  using Row = std::uint64_t;
  /// Number of rows; the row of (y, cb) has the index y * 64 + cb.
  static constexpr std::size_t kRows = 64U * 64U;

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
  /// Number of cells in the set; counts them, which takes some microseconds.
  std::size_t size() const;
  bool operator==(const CellSet&) const = default;

 private:
  std::array<Row, kRows> rows_{};
};

/// The kind of adjacency of cells: sharing a face (6), or at least a corner (26).
enum class CellNeighbors : std::uint8_t { k6, k26 };

/// Returns all cells of `within` that are connected, through cells of `within`, to a cell of `seeds`. Seeds
/// outside `within` are ignored. Takes about 0.1 ms for the whole cube.
CellSet connectedCells(const CellSet& seeds, const CellSet& within, CellNeighbors neighbors);
/// Returns all cells that share a face with one of `cells`. The result may contain some of `cells`
/// themselves.
CellSet facesOf(const CellSet& cells);

}  // namespace colortool
