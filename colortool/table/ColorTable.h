// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "colortool/image/ClassifyRows.h"
#include "colortool/image/ColorClasses.h"
#include "robotlink/base/Image.h"

namespace colortool {

/// A look-up table from colors to classes: a cube of 64 x 64 x 64 cells over Y, Cb and Cr, each cell 4 values
/// wide, with one byte per cell in the order of the GermanTeam's ColorTable64: [Y / 4][Cb / 4][Cr / 4]. A
/// plain value of 256 KB. Const functions may be called from several threads at a time.
class ColorTable {
 public:
  /// Cells per side.
  static constexpr int kCells = 64;
  /// Width of a cell, in values of a channel.
  static constexpr double kCellSize = 4;

  static constexpr std::size_t kCellCount = std::size_t{kCells} * kCells * kCells;

  /// An empty table: all cells are of no class.
  ColorTable() : cells_(kCellCount + kCellPadding, ColorClasses::kNone) {}

  /// The index of a color's cell in cells().
  static constexpr std::size_t cellOf(robotlink::YCbCr color) {
    return (static_cast<std::size_t>(color.y >> 2) << 12) | (static_cast<std::size_t>(color.cb >> 2) << 6) |
           static_cast<std::size_t>(color.cr >> 2);
  }
  std::uint8_t classOf(robotlink::YCbCr color) const { return cells_[cellOf(color)]; }
  std::uint8_t cell(int y, int cb, int cr) const { return cells_[indexOf(y, cb, cr)]; }
  void setCell(int y, int cb, int cr, std::uint8_t colorClass) { cells_[indexOf(y, cb, cr)] = colorClass; }
  std::span<const std::uint8_t, kCellCount> cells() const {
    return std::span<const std::uint8_t, kCellCount>(cells_.data(), kCellCount);
  }
  bool operator==(const ColorTable&) const = default;

  /// Builds a table from `cells` in other class numbers: `numbers[n]` is the new number of class n. Cells of
  /// classes past the end of `numbers` become "none"; the table is empty if the number of cells is not
  /// kCellCount.
  static ColorTable translated(std::span<const std::uint8_t> cells, std::span<const std::uint8_t> numbers);

  /// kPlain disables vector instructions, for tests and benchmarks.
  enum class Instructions : std::uint8_t { kFastest, kPlain };
  /// Writes the class of each pixel into `classes`, a kMono8 image of the same size; a kMono8 input yields
  /// "none" everywhere. Uses AVX2 where available, with the same results. `classes` reuses its memory from
  /// call to call.
  void classify(const robotlink::ImageView& image, robotlink::Image& classes,
                Instructions instructions = Instructions::kFastest) const;

 private:
  static constexpr std::size_t indexOf(int y, int cb, int cr) {
    return (static_cast<std::size_t>(y) * kCells + static_cast<std::size_t>(cb)) * kCells +
           static_cast<std::size_t>(cr);
  }

  /// kCellCount cells, followed by kCellPadding bytes that vector code may read.
  std::vector<std::uint8_t> cells_;
};

/// Renders an image of class numbers (kMono8) in the display colors of the classes (kRgb8).
robotlink::Image shownImage(const robotlink::ImageView& classImage, const ColorClasses& classes);

}  // namespace colortool
