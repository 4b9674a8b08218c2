// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "robotlink/base/Geometry.h"

namespace robotlink {

// What drawings of images and of scenes have in common: curves as points, arrow heads, fills as triangles.

/// 32 points of an ellipse, evenly in its parameter. `angle`: of the first axis against the x-axis, towards
/// the y-axis.
std::vector<Vector2> ellipsePoints(const Vector2& center, const Vector2& radii, double angle);

/// The ends of the two strokes of an arrow's head at `to`.
struct ArrowHead {
  Vector2 left, right;
};
ArrowHead arrowHead(const Vector2& from, const Vector2& to, double length);

/// Triangles, as triples of indices into `corners`, that fill a simple polygon of any orientation, convex or
/// not (ear clipping). What crosses itself is filled somehow. Fewer than three corners have no area.
std::vector<std::uint32_t> triangulate(std::span<const Vector2> corners);

}  // namespace robotlink
