// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "colortool/table/ColorTable.h"

namespace colortool {

/// A set of cells of a color table with one bit per block of kBlock cells along Cr, the unit in which tables
/// are decided. A plain value of 2 KB.
class CellBlocks {
 public:
  /// Cells per block.
  static constexpr int kBlock = 16;
  static constexpr int kBlocksPerRow = ColorTable::kCells / kBlock;
  /// Number of rows of cells along Cr; the row of (y, cb) has the index y * 64 + cb.
  static constexpr std::size_t kRows = std::size_t{ColorTable::kCells} * ColorTable::kCells;

  /// The blocks of the cells `first` to `last` of a row, both inclusive; bit i is the block of the cells from
  /// i * kBlock on.
  static unsigned blocksOf(int first, int last) {
    return (2U << static_cast<unsigned>(last / kBlock)) - (1U << static_cast<unsigned>(first / kBlock));
  }
  /// Adds blocks of a row, as of blocksOf().
  void includeBlocks(std::size_t row, unsigned blocks) {
    words_[row / kRowsPerWord] |= std::uint64_t{blocks} << (row % kRowsPerWord * kBlocksPerRow);
  }
  /// Adds the same blocks of the rows from `first` up to, not including, `end`.
  void includeBlocks(std::size_t first, std::size_t end, unsigned blocks) {
    for (std::size_t row = first; row < end;) {
      std::uint64_t word = 0;
      const std::size_t at = row / kRowsPerWord;
      for (; row < end && row / kRowsPerWord == at; ++row)
        word |= std::uint64_t{blocks} << (row % kRowsPerWord * kBlocksPerRow);
      words_[at] |= word;
    }
  }
  void include(const CellBlocks& others) {
    for (std::size_t i = 0; i < words_.size(); ++i) words_[i] |= others.words_[i];
  }
  void includeAll() { words_.fill(~std::uint64_t{0}); }
  void clear() { words_.fill(0); }
  /// The blocks of a row, as of blocksOf().
  unsigned row(std::size_t row) const {
    return static_cast<unsigned>(words_[row / kRowsPerWord] >> (row % kRowsPerWord * kBlocksPerRow)) &
           ((1U << kBlocksPerRow) - 1);
  }

 private:
  static constexpr std::size_t kRowsPerWord = 64 / kBlocksPerRow;
  std::array<std::uint64_t, kRows / kRowsPerWord> words_{};
};

}  // namespace colortool
