// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "colortool/image/Regions.h"

namespace modules {

/// Removes regions of fewer than `fringeArea` pixels from those of the ball's color that touch a larger
/// region of a color that mixes to the ball's where it meets another one. A true ball that is as small is
/// farther away than anybody plays it. Boxes that are two pixels apart touch, because scan lines leave pixels
/// out.
inline void removeFringes(std::vector<colortool::Region>& ball, const std::vector<colortool::Region>& mixed,
                          int fringeArea) {
  constexpr int kGap = 2;
  const auto touch = [](const colortool::Region& a, const colortool::Region& b) {
    return a.left <= b.right + kGap && b.left <= a.right + kGap && a.top <= b.bottom + kGap &&
           b.top <= a.bottom + kGap;
  };
  std::erase_if(ball, [&](const colortool::Region& region) {
    return region.area < fringeArea && std::ranges::any_of(mixed, [&](const colortool::Region& other) {
             return other.area > region.area && touch(region, other);
           });
  });
}

}  // namespace modules
