// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "colortool/CellSet.h"
#include "colortool/ColorSpaces.h"

namespace widgets {

/// Where the cells of a colour table are in a colour space: their corners and their centres, as
/// colortool::placeIn() has it. Immutable; 6 MB, made in some 20 ms.
class ColorLattice {
 public:
  static constexpr int kCorners = colortool::ColorTable::kCells + 1;  ///< a side

  explicit ColorLattice(colortool::ColorSpace space);

  colortool::ColorSpace space() const { return space_; }
  /// Corners count as cells do: [y][cb][cr].
  static constexpr std::uint32_t cornerOf(int y, int cb, int cr) {
    return static_cast<std::uint32_t>((y * kCorners + cb) * kCorners + cr);
  }
  const Eigen::Vector3f& corner(std::uint32_t index) const { return corners_[index]; }
  const Eigen::Vector3f& center(std::size_t cell) const { return centers_[cell]; }
  /// The eight corners of a cell; bit 0 of the index is the upper one along Y, bit 1 along Cb, bit 2 along
  /// Cr.
  std::array<Eigen::Vector3f, 8> cornersOf(std::size_t cell) const;
  /// The cells of colours that the space has: all in YCbCr, elsewhere those that are RGB colours, too.
  const colortool::CellSet& real() const { return real_; }

 private:
  colortool::ColorSpace space_;
  std::vector<Eigen::Vector3f> corners_, centers_;
  colortool::CellSet real_;
};

/// Which value of a space's channel, from 0 to 1, a place has.
float channelAt(colortool::ColorSpace space, int channel, const Eigen::Vector3f& place);

}  // namespace widgets
