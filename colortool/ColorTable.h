// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "colortool/ClassifyRows.h"
#include "colortool/ColorClasses.h"
#include "robotlink/base/Image.h"

namespace colortool {

/// Which class each colour belongs to: a cube of 64 x 64 x 64 cells over Y, Cb and Cr, each cell 4 values
/// wide, one byte a cell, in the order of the GermanTeam's ColorTable64: [Y / 4][Cb / 4][Cr / 4]. A plain
/// value of 256 KB.
class ColorTable {
 public:
  static constexpr int kCells = 64;       ///< a side
  static constexpr double kCellSize = 4;  ///< values of a channel

  static constexpr std::size_t kCellCount = std::size_t{kCells} * kCells * kCells;

  ColorTable() : cells_(kCellCount + kCellPadding, ColorClasses::kNone) {}

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

  /// A table of other classes: `numbers[n]` is the class that its class n is here. Cells of classes past the
  /// end of `numbers` are of none, and all are if there are not as many as a table has.
  static ColorTable translated(std::span<const std::uint8_t> cells, std::span<const std::uint8_t> numbers);

  enum class Instructions : std::uint8_t { kFastest, kPlain };
  /// The class of each pixel, as a kMono8 image of the same size; kMono8 yields "none" everywhere. Uses AVX2
  /// where there is AVX2, to the same results. `classes` keeps its memory from call to call.
  void classify(const robotlink::ImageView& image, robotlink::Image& classes,
                Instructions instructions = Instructions::kFastest) const;

 private:
  static constexpr std::size_t indexOf(int y, int cb, int cr) {
    return (static_cast<std::size_t>(y) * kCells + static_cast<std::size_t>(cb)) * kCells +
           static_cast<std::size_t>(cr);
  }

  std::vector<std::uint8_t> cells_;  // and what vector code may read behind them
};

/// An image of classes in the colours that the classes are shown in (kRgb8).
robotlink::Image shownImage(const robotlink::ImageView& classImage, const ColorClasses& classes);

}  // namespace colortool
