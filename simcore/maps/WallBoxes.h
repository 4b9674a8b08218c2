// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "robotlink/base/GroundMap.h"

namespace simcore {

/// A piece of a wall seen from above: a rectangle rotated by `angle` about its center. Meters and radians in
/// the map's frame.
struct WallBox {
  robotlink::Vector2 center = robotlink::Vector2::Zero();
  robotlink::Vector2 size = robotlink::Vector2::Zero();
  double angle = 0;
};

/// Converts a map's lines and points to walls. Each line becomes a box 1 cm thick. A point is a square with
/// the side of the map's resolution; neighboring points are merged into a few rectangles, and points already
/// covered by a line's box are dropped. With the usual resolution of 2 cm, no surface moves by more than 2 cm
/// in either direction.
std::vector<WallBox> wallBoxes(const robotlink::GroundMap& map);

}  // namespace simcore
