// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace robotcontrol {
class WorldObjects;
}
namespace simcore {
class Simulation;
}

namespace app {

class ExternalControllers;

/// Adds the controllers of a simulation to its objects, each with the views that it adds below it, then those
/// that are remote; these may be null.
void addControllers(const simcore::Simulation& simulation, const ExternalControllers* external,
                    robotcontrol::WorldObjects& to);

}  // namespace app
