// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/base/GroundMap.h"

namespace robotcontrol {
class GroundMap;
}

namespace robotlink {

/// Writes everything but resolution, notes and the time, which is the sender's to set. Points become floats,
/// which keeps a building's to some micrometres.
void assign(robotcontrol::GroundMap& to, const GroundMap& from);

/// The map of a package, with the default resolution. Whatever a link delivers is a map: a place of a kind
/// that is not known is one of the kind kOther, half a point is left out, and so is what is not finite.
GroundMap groundMap(const robotcontrol::GroundMap& from);

}  // namespace robotlink
