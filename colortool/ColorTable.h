// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

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

  ColorTable() : cells_(static_cast<std::size_t>(kCells) * kCells * kCells, ColorClasses::kNone) {}

  static constexpr std::size_t cellOf(robotlink::YCbCr color) {
    return (static_cast<std::size_t>(color.y >> 2) << 12) | (static_cast<std::size_t>(color.cb >> 2) << 6) |
           static_cast<std::size_t>(color.cr >> 2);
  }
  std::uint8_t classOf(robotlink::YCbCr color) const { return cells_[cellOf(color)]; }
  std::uint8_t cell(int y, int cb, int cr) const { return cells_[indexOf(y, cb, cr)]; }
  void setCell(int y, int cb, int cr, std::uint8_t colorClass) { cells_[indexOf(y, cb, cr)] = colorClass; }
  const std::vector<std::uint8_t>& cells() const { return cells_; }
  bool operator==(const ColorTable&) const = default;

  /// A table of other classes: `numbers[n]` is the class that its class n is here. Cells of classes past the
  /// end of `numbers` are of none, and all are if there are not as many as a table has.
  static ColorTable translated(std::span<const std::uint8_t> cells, std::span<const std::uint8_t> numbers);

  /// The class of each pixel, as a kMono8 image of the same size. Takes kYuyv and kRgb8; anything else yields
  /// "none" everywhere. `classes` keeps its memory from call to call.
  void classify(const robotlink::ImageView& image, robotlink::Image& classes) const;

 private:
  static constexpr std::size_t indexOf(int y, int cb, int cr) {
    return (static_cast<std::size_t>(y) * kCells + static_cast<std::size_t>(cb)) * kCells +
           static_cast<std::size_t>(cr);
  }
  void classifyYuyvRow(const std::uint8_t* pixels, int width, std::uint8_t* classes) const;
  void classifyRgbRow(const std::uint8_t* pixels, int width, std::uint8_t* classes) const;

  std::vector<std::uint8_t> cells_;
};

/// An image of classes in the colours that the classes are shown in (kRgb8).
robotlink::Image shownImage(const robotlink::ImageView& classImage, const ColorClasses& classes);

}  // namespace colortool
