// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/base/Geometry.h"

namespace robotlink {

/// A place on Earth, as GPS receivers report it (WGS 84).
struct GlobalPosition {
  double latitude = 0, longitude = 0;  ///< degrees, north and east positive
  double altitude = 0;                 ///< m above the ellipsoid
  bool operator==(const GlobalPosition&) const = default;
};

/// Where a point is on Earth that lies so many m to the east, to the north and above `origin`, measured along
/// the plane that touches the Earth there.
GlobalPosition globalPosition(const GlobalPosition& origin, const Vector3& eastNorthUp);

}  // namespace robotlink
