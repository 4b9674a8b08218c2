// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "colortool/CellSet.h"
#include "widgets/color/ColorLattice.h"

namespace widgets {

/// A plane that cuts something off a colour space, to look inside: across the direction of view, or at a
/// value of one of the space's channels (of a hue: two planes, a wedge stays).
struct ColorSpaceCut {
  enum class Along : std::uint8_t { kNothing, kView, kFirst, kSecond, kThird };

  Along along = Along::kNothing;
  double at = 0.5;     ///< from 0 to 1; along the view from the farthest to the nearest corner
  bool other = false;  ///< what is above stays instead of what is below

  bool operator==(const ColorSpaceCut&) const = default;
};

/// The cells whose centres a cut leaves. 0.1 ms without a cut, 0.5 ms along the view or a cube's axis.
colortool::CellSet cellsLeftBy(const ColorSpaceCut& cut, const ColorLattice& lattice,
                               const Eigen::Vector3f& toViewer);

}  // namespace widgets
