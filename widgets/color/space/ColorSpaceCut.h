// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "colortool/table/CellSet.h"
#include "widgets/color/space/ColorLattice.h"

namespace widgets {

/// A plane that cuts off a part of a color space, so that its inside is visible: perpendicular to the
/// direction of view, or at a value of one of the space's channels (for a hue this leaves a wedge between two
/// planes).
struct ColorSpaceCut {
  /// The plane's normal: none, the view, or a channel.
  enum class Along : std::uint8_t { kNothing, kView, kFirst, kSecond, kThird };

  Along along = Along::kNothing;
  /// Position, 0 to 1: along the view from the farthest to the nearest corner of the cube, else the channel's
  /// value.
  double at = 0.5;
  /// Whether the part above the plane is kept instead of that below.
  bool other = false;

  bool operator==(const ColorSpaceCut&) const = default;
};

/// The cells whose centers are kept. `toViewer` is used by cuts along the view only. Takes about 0.1 ms
/// without a cut, 0.5 ms along the view or an axis of a cube.
colortool::CellSet cellsLeftBy(const ColorSpaceCut& cut, const ColorLattice& lattice,
                               const Eigen::Vector3f& toViewer);

}  // namespace widgets
