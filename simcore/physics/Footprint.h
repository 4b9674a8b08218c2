// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/base/Geometry.h"

struct dxGeom;

namespace simcore {

/// A rectangle on the ground that holds a solid or a model, seen from above.
struct Footprint {
  robotlink::Vector2 center = {0, 0};
  robotlink::Vector2 along = {1, 0};  ///< unit
  double halfLength = 0, halfWidth = 0;

  /// Whether two have a point in common; exact.
  friend bool meet(const Footprint& a, const Footprint& b);
};

/// The footprint of a solid of finite size: exact for an upright box, the bounds of others.
Footprint footprintOf(dxGeom* geom);

}  // namespace simcore
