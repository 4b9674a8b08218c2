// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace robotlink {
class CommandTable;
}

namespace app {

class OpenPlatform;

/// Attaches the commands that control a simulation: simulation.start, simulation.speed, simulation.light and
/// so on. What is open must outlive the command table.
void addSimulationCommands(robotlink::CommandTable& commands, OpenPlatform& open);

}  // namespace app
