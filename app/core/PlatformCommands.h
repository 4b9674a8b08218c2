// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "robotlink/commands/CommandTable.h"

namespace app {

class OpenPlatform;

/// The declarations of the commands that open platforms, as the adapters declare them: one that opens a
/// source (simulation.open, log.open), and one with all fields of the form (simulation.setup, robot.connect).
std::vector<robotlink::CommandTable::Command> platformCommands();

/// The declarations of all commands of the workbench, by name: platformCommands() and the catalog.
std::vector<robotlink::CommandTable::Command> allCommands();

/// Attaches the commands that open platforms, and layout.open. What is open must outlive the command table.
void addPlatformCommands(robotlink::CommandTable& commands, OpenPlatform& open);

}  // namespace app
