// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "robotlink/base/GroundMap.h"

namespace simcore {

/// A piece of a wall, seen from above: a rectangle turned by `angle`. Metres and radians, in the map's frame.
struct WallBox {
  robotlink::Vector2 center = robotlink::Vector2::Zero();
  robotlink::Vector2 size = robotlink::Vector2::Zero();
  double angle = 0;
};

/// What a map's lines and points are as walls. Each line is one box of 1 cm thickness. A point is a square of
/// the map's resolution; neighbouring ones are gathered into few rectangles, and what the box of a line
/// already stands for is left out. With the usual resolution of 2 cm, no surface moves by more than 2 cm,
/// neither outwards nor inwards.
std::vector<WallBox> wallBoxes(const robotlink::GroundMap& map);

}  // namespace simcore
