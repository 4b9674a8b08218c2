// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "robotlink/base/Error.h"

namespace robotcontrol {
class Request;
}

namespace app {

class SimulatedWorld;

/// Whether a request only changes a simulated world, independent of its robots' programs: it places, turns,
/// throws, pins, drags or pushes objects, moves doors, sets actuators, or changes light or the errors of
/// sensors.
bool changesWorld(const robotcontrol::Request& request);

/// Fulfills such a request; `stopped` are the robots that must not move. Fails with the reason, changing
/// nothing, if it is refused. Called in the thread of the world.
robotlink::Result<void> changeWorld(SimulatedWorld& world, const robotcontrol::Request& request,
                                    const std::vector<std::string>& stopped);

}  // namespace app
