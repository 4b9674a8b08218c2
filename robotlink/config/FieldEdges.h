// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "robotlink/base/Geometry.h"

namespace robotlink {

struct FieldDescription;

/// A straight edge between green and white on the ground of the field, m.
struct FieldEdge {
  Vector2 start = Vector2::Zero();
  Vector2 end = Vector2::Zero();

  /// The direction of the edge, from -pi/2 to pi/2, rad.
  double direction() const;
  /// The point of the edge that is nearest to a point.
  Vector2 nearest(const Vector2& point) const;
};

/// Returns both edges of all lines, and the feet of the walls, as the field's description has them. The
/// center circle is a polygon of 16 sides.
std::vector<FieldEdge> fieldEdges(const FieldDescription& field);

}  // namespace robotlink
