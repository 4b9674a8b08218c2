// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/base/GroundMap.h"

namespace robotcontrol {
class GroundMap;
}

namespace robotlink {

/// Writes everything except resolution, notes and the timestamp, which the sender sets. Points become floats,
/// which is exact to some micrometers within a building.
void assign(robotcontrol::GroundMap& to, const GroundMap& from);

/// Reads the map of a package, with the default resolution. It never fails: places of an unknown kind become
/// kOther; an incomplete point, and lines, points and places that are not finite, are dropped.
GroundMap groundMap(const robotcontrol::GroundMap& from);

}  // namespace robotlink
