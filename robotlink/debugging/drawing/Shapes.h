// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "robotlink/base/Geometry.h"

namespace robotlink {

// Geometry shared by drawings in images and in scenes: curves as points, arrow heads, fills as triangles.

/// Returns 32 points of an ellipse, evenly spaced in its parameter. `angle` is that of the first axis to the
/// x-axis, toward the y-axis, rad.
std::vector<Vector2> ellipsePoints(const Vector2& center, const Vector2& radii, double angle);

/// The ends of the two strokes of an arrow's head.
struct ArrowHead {
  Vector2 left, right;
};
/// The head of an arrow from `from` to `to`, with strokes of that length.
ArrowHead arrowHead(const Vector2& from, const Vector2& to, double length);

/// Fills a simple polygon of either orientation, convex or not, with triangles (ear clipping); returns
/// triples of indices into `corners`. A polygon that crosses itself is filled in some way. Empty for fewer
/// than three corners.
std::vector<std::uint32_t> triangulate(std::span<const Vector2> corners);

}  // namespace robotlink
