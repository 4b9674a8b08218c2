// SPDX-License-Identifier: GPL-3.0-or-later
// The list of all ports, which SimulationPorts.cpp makes.
#pragma once

#include <vector>

#include "simcore/devices/Ports.h"
#include "simcore/world/Port.h"
#include "simcore/world/WorldDescription.h"

namespace simcore {

/// All ports that a world describes, first those of devices, then the truth about each model.
std::vector<Port> portsOf(const Ports& ports, const WorldDescription& world);

}  // namespace simcore
