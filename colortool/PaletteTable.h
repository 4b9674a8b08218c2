// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "colortool/ColorTable.h"

namespace colortool {

/// How the colours of a scene may look to its camera.
struct LightingRange {
  double darkest = 0.3;  ///< share of full light in the deepest shadow
  double brightest = 1.05;
  double usual = 0.75;  ///< decides between greys, which differ in nothing but brightness
  double tolerance =
      26;  ///< how far a colour may be off, in values of Cb and Cr, by noise and by mixing at edges
  double brightnessWeight = 0.35;  ///< of a difference in Y against one in Cb or Cr
  bool operator==(const LightingRange&) const = default;
};

/// The colour table of a scene whose colours are known: the start-up table of simulated robots, and what a
/// calibration can start from.
///
/// A dull surface of colour c under light of strength f shows f * c; in YCbCr (with Cb and Cr from 128) these
/// colours are a stretch of a straight line through black. Each cell goes to the nearest such stretch, if one
/// is near enough. All of `palette` compete; cells won by a colour without a class are "none". About 5 ms.
ColorTable paletteTable(std::span<const NamedColor> palette, const ColorClasses& classes,
                        const LightingRange& lighting = {});

}  // namespace colortool
