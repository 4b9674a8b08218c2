// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/space/ColorLattice.h"

#include <cmath>
#include <numbers>

namespace widgets {

using colortool::ColorSpace;
using colortool::ColorTable;

namespace {

constexpr auto kSize = static_cast<float>(ColorTable::kCellSize);
/// A cell at the border of the RGB colors counts if its center is outside by at most this much of a channel:
/// half a cell.
constexpr float kTolerance = 4;

/// The lower end of a cell, half a value below its first value.
float lowerEnd(int cell) {
  return kSize * static_cast<float>(cell) - 0.5F;
}
float middle(int cell) {
  return lowerEnd(cell) + kSize / 2;
}

}  // namespace

ColorLattice::ColorLattice(ColorSpace space) : space_(space) {
  corners_.reserve(std::size_t{kCorners} * kCorners * kCorners);
  centers_.reserve(ColorTable::kCellCount);
  for (int y = 0; y < kCorners; ++y) {
    for (int cb = 0; cb < kCorners; ++cb) {
      for (int cr = 0; cr < kCorners; ++cr)
        corners_.push_back(colortool::placeIn(space, {lowerEnd(y), lowerEnd(cb), lowerEnd(cr)}));
    }
  }
  for (int y = 0; y < ColorTable::kCells; ++y) {
    for (int cb = 0; cb < ColorTable::kCells; ++cb) {
      for (int cr = 0; cr < ColorTable::kCells; ++cr) {
        const colortool::ColorValue value(middle(y), middle(cb), middle(cr));
        if (space == ColorSpace::kYCbCr || colortool::hasRgb(value, kTolerance)) real_.set(centers_.size());
        centers_.push_back(colortool::placeIn(space, value));
      }
    }
  }
}

std::array<Eigen::Vector3f, 8> ColorLattice::cornersOf(std::size_t cell) const {
  const int y = static_cast<int>(cell >> 12U), cb = static_cast<int>(cell >> 6U & 63U),
            cr = static_cast<int>(cell & 63U);
  std::array<Eigen::Vector3f, 8> corners;
  for (int i = 0; i < 8; ++i) {
    corners[static_cast<std::size_t>(i)] =
        corner(cornerOf(y + (i & 1), cb + (i >> 1 & 1), cr + (i >> 2 & 1)));
  }
  return corners;
}

float channelAt(ColorSpace space, int channel, const Eigen::Vector3f& place) {
  if (!colortool::isCylinder(space)) {
    // In YCbCr z is Y, x is Cb and y is Cr; in RGB the channels are in order.
    const int axis = space == ColorSpace::kYCbCr ? (channel + 2) % 3 : channel;
    return place[axis] + 0.5F;
  }
  if (channel == 2) return place.z() + 0.5F;
  if (channel == 1) return 2 * place.head<2>().norm();
  const float turn = std::atan2(place.y(), place.x()) / (2 * std::numbers::pi_v<float>);
  return turn < 0 ? turn + 1 : turn;
}

}  // namespace widgets
