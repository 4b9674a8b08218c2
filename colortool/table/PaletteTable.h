// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "colortool/table/ColorTable.h"

namespace colortool {

/// The range in which the colors of a scene can appear in its camera's images. Light is a share of full
/// light.
struct LightingRange {
  /// The deepest shadow.
  double darkest = 0.3;
  /// The brightest light; above 1 to allow for noise.
  double brightest = 1.05;
  /// The usual light; it decides between grays, which differ in brightness only.
  double usual = 0.75;
  /// Maximum distance of a color from its line, in values of Cb and Cr, caused by noise and by mixed pixels
  /// at edges.
  double tolerance = 26;
  /// Weight of a difference in Y relative to one in Cb or Cr.
  double brightnessWeight = 0.35;
  bool operator==(const LightingRange&) const = default;
};

/// Computes the color table of a scene whose colors are known: the initial table of simulated robots, and a
/// starting point for a calibration.
///
/// A matte surface of color c under light of strength f appears as f * c; in YCbCr (with Cb and Cr relative
/// to 128) these colors form a segment of a straight line through black. Each cell goes to the nearest
/// segment within the tolerance. All colors of `palette` compete; cells won by a color that is not in
/// `classes` are "none". Takes about 5 ms.
ColorTable paletteTable(std::span<const NamedColor> palette, const ColorClasses& classes,
                        const LightingRange& lighting = {});

}  // namespace colortool
