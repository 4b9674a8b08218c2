// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace robotlink {
class CommandTable;
}

namespace app {

class OpenPlatform;

/// Adds the commands that open platforms, as the adapters declare them: one that opens a source
/// (simulation.open, log.open), and one with all fields of the form (simulation.setup, robot.connect). Also
/// adds layout.open. What is open must outlive the command table.
void addPlatformCommands(robotlink::CommandTable& commands, OpenPlatform& open);

}  // namespace app
