// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "robotlink/base/Geometry.h"

namespace simcore {

/// A house of 8 m by 6 m with a wall that leaves a door of 2 m, a pillar of points, a forbidden corner, and a
/// home.
inline constexpr const char* kHouse =
    "2D-Map\nResolution: 20\n"
    "Cairn: RobotHome 1500 1500 90 \"\" ICON \"Home\"\n"
    "Cairn: ForbiddenArea 0 0 0 \"\" ICON \"\" 5000 0 8000 3000\n"
    "LINES\n0 0 8000 0\n8000 0 8000 6000\n8000 6000 0 6000\n0 6000 0 0\n4000 0 4000 4000\n"
    "DATA\n2000 4000\n2020 4000\n2000 4020\n2020 4020\n";

/// The least distance between two places.
inline double leastDistance(const std::vector<robotlink::Pose2>& places) {
  double least = 1e9;
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k)
      least = std::min(least, (places[i].translation() - places[k].translation()).norm());
  }
  return least;
}

}  // namespace simcore
