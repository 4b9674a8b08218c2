// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/table/CellSet.h"

#include <bit>
#include <vector>

namespace colortool {
namespace {

using Row = CellSet::Row;
constexpr std::size_t kSetSide = 64;
/// Rows in a grid with an empty row all around, so that each row has its neighbors.
constexpr std::size_t kPaddedSide = kSetSide + 2;
using PaddedRows = std::array<Row, kPaddedSide * kPaddedSide>;

constexpr std::size_t paddedRow(std::size_t row) {
  return (row / kSetSide + 1) * kPaddedSide + row % kSetSide + 1;
}

PaddedRows padded(const CellSet& cells) {
  PaddedRows rows{};
  for (std::size_t row = 0; row < CellSet::kRows; ++row) rows[paddedRow(row)] = cells.row(row);
  return rows;
}

/// The runs of `within` that contain a bit of `seeds`, which must be a subset of `within`.
Row connectedInRow(Row seeds, Row within) {
  // Upwards the carry of an addition runs from the lowest seed to the end of the run; downwards the reach
  // doubles in each step.
  Row filled = seeds | (within & ~(within + seeds));
  Row open = within;
  for (int step = 1; step < 64; step *= 2) {
    filled |= open & (filled >> step);
    open &= open >> step;
  }
  return filled;
}

Row nearFaces(const PaddedRows& rows, std::size_t at) {
  return rows[at - kPaddedSide] | rows[at + kPaddedSide] | rows[at - 1] | rows[at + 1];
}

Row nearCorners(const PaddedRows& rows, std::size_t at) {
  const Row near = nearFaces(rows, at) | rows[at - kPaddedSide - 1] | rows[at - kPaddedSide + 1] |
                   rows[at + kPaddedSide - 1] | rows[at + kPaddedSide + 1];
  return near | near << 1U | near >> 1U;
}

/// Sweeps back and forth over the rows that are not full until nothing changes.
template <Row (*near)(const PaddedRows&, std::size_t)>
void sweep(PaddedRows& filled, const PaddedRows& within, std::vector<std::size_t> pending) {
  for (bool changed = true; changed;) {
    changed = false;
    std::size_t left = 0;
    for (const std::size_t at : pending) {
      const Row reached = (filled[at] | near(filled, at)) & within[at];
      if (reached != filled[at]) {
        filled[at] = connectedInRow(reached, within[at]);
        changed = true;
      }
      if (filled[at] != within[at]) pending[left++] = at;
    }
    pending.resize(left);
    std::ranges::reverse(pending);
  }
}

}  // namespace

std::size_t CellSet::size() const {
  std::size_t count = 0;
  for (const Row row : rows_) count += static_cast<std::size_t>(std::popcount(row));
  return count;
}

CellSet connectedCells(const CellSet& seeds, const CellSet& within, CellNeighbors neighbors) {
  const PaddedRows open = padded(within);
  PaddedRows filled{};
  std::vector<std::size_t> pending;
  for (std::size_t row = 0; row < CellSet::kRows; ++row) {
    if (within.row(row) == 0) continue;
    const std::size_t at = paddedRow(row);
    filled[at] = connectedInRow(seeds.row(row) & open[at], open[at]);
    if (filled[at] != open[at]) pending.push_back(at);
  }
  if (neighbors == CellNeighbors::k6) {
    sweep<nearFaces>(filled, open, std::move(pending));
  } else {
    sweep<nearCorners>(filled, open, std::move(pending));
  }
  CellSet result;
  for (std::size_t row = 0; row < CellSet::kRows; ++row) result.row(row) = filled[paddedRow(row)];
  return result;
}

CellSet facesOf(const CellSet& cells) {
  const PaddedRows rows = padded(cells);
  CellSet result;
  for (std::size_t row = 0; row < CellSet::kRows; ++row) {
    const Row own = cells.row(row);
    result.row(row) = nearFaces(rows, paddedRow(row)) | own << 1U | own >> 1U;
  }
  return result;
}

}  // namespace colortool
