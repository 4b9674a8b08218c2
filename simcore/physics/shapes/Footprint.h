// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/base/Geometry.h"

struct dxGeom;

namespace simcore {

/// A rectangle on the ground that contains a solid or a model, seen from above.
struct Footprint {
  robotlink::Vector2 center = {0, 0};
  /// Unit vector.
  robotlink::Vector2 along = {1, 0};
  double halfLength = 0, halfWidth = 0;

  /// Whether two rectangles have a point in common; exact (separating axes).
  friend bool meet(const Footprint& a, const Footprint& b);
};

/// The footprint of a finite solid: exact for an upright box, otherwise its bounding box.
Footprint footprintOf(dxGeom* geom);

}  // namespace simcore
