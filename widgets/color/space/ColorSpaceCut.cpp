// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/space/ColorSpaceCut.h"

#include <numbers>

namespace widgets {
namespace {

/// The distance of the corners of the cube from the origin.
constexpr float kFarthestCorner = std::numbers::sqrt3_v<float> / 2;

template <typename Keeps>
colortool::CellSet cellsWhere(const ColorLattice& lattice, const Keeps& keeps) {
  colortool::CellSet cells;
  for (std::size_t row = 0, cell = 0; row < colortool::CellSet::kRows; ++row) {
    colortool::CellSet::Row bits = 0;
    for (unsigned bit = 0; bit < 64; ++bit, ++cell)
      bits |= colortool::CellSet::Row{keeps(lattice.center(cell))} << bit;
    cells.row(row) = bits;
  }
  return cells;
}

}  // namespace

colortool::CellSet cellsLeftBy(const ColorSpaceCut& cut, const ColorLattice& lattice,
                               const Eigen::Vector3f& toViewer) {
  using Along = ColorSpaceCut::Along;
  const auto at = static_cast<float>(cut.at);
  if (cut.along == Along::kNothing) {
    return cellsWhere(lattice, [](const Eigen::Vector3f&) { return true; });
  }
  if (cut.along == Along::kView) {
    const float depth = (2 * at - 1) * kFarthestCorner;
    return cellsWhere(
        lattice, [&](const Eigen::Vector3f& place) { return (place.dot(toViewer) <= depth) != cut.other; });
  }
  const int channel = static_cast<int>(cut.along) - static_cast<int>(Along::kFirst);
  return cellsWhere(lattice, [&](const Eigen::Vector3f& place) {
    return (channelAt(lattice.space(), channel, place) <= at) != cut.other;
  });
}

}  // namespace widgets
