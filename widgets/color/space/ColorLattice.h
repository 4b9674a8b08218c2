// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "colortool/image/ColorSpaces.h"
#include "colortool/table/CellSet.h"

namespace widgets {

/// The places of a color table's cells in a color space: their corners and centers, as colortool::placeIn()
/// defines them (a cube of side 1 around the origin). Immutable; 6 MB, computed in about 20 ms.
class ColorLattice {
 public:
  /// Corners along one axis.
  static constexpr int kCorners = colortool::ColorTable::kCells + 1;

  explicit ColorLattice(colortool::ColorSpace space);

  colortool::ColorSpace space() const { return space_; }
  /// Index of a corner; the order is that of cells: [y][cb][cr].
  static constexpr std::uint32_t cornerOf(int y, int cb, int cr) {
    return static_cast<std::uint32_t>((y * kCorners + cb) * kCorners + cr);
  }
  const Eigen::Vector3f& corner(std::uint32_t index) const { return corners_[index]; }
  const Eigen::Vector3f& center(std::size_t cell) const { return centers_[cell]; }
  /// The eight corners of a cell; bit 0 of the index is the upper one along Y, bit 1 along Cb, bit 2 along
  /// Cr.
  std::array<Eigen::Vector3f, 8> cornersOf(std::size_t cell) const;
  /// The cells whose colors exist in the space: all in YCbCr; in other spaces those that are RGB colors.
  const colortool::CellSet& real() const { return real_; }

 private:
  colortool::ColorSpace space_;
  std::vector<Eigen::Vector3f> corners_, centers_;
  colortool::CellSet real_;
};

/// Value of a channel (0 to 2) of the space at a place, 0 to 1.
float channelAt(colortool::ColorSpace space, int channel, const Eigen::Vector3f& place);

}  // namespace widgets
