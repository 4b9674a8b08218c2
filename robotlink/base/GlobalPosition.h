// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/base/Geometry.h"

namespace robotlink {

/// A position on Earth as GPS receivers report it, on the ellipsoid of WGS 84.
struct GlobalPosition {
  /// Degrees, north and east positive.
  double latitude = 0, longitude = 0;
  /// Meters above the ellipsoid.
  double altitude = 0;
  bool operator==(const GlobalPosition&) const = default;
};

/// Converts a position in the local east-north-up frame at `origin` (meters, along the tangent plane) to a
/// position on Earth. Well defined at the poles, too.
GlobalPosition globalPosition(const GlobalPosition& origin, const Vector3& eastNorthUp);

}  // namespace robotlink
