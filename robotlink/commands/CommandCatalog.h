// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "robotlink/commands/CommandTable.h"

namespace robotlink {

/// The declarations of all commands of the workbench, except those that kinds of platforms declare: their
/// names, arguments and help, without handlers. A new command has its row here, and its handler where it
/// acts: `commands.attach("robot.stop", handler)`.
std::vector<CommandTable::Command> commandCatalog();

/// The rows of commandCatalog() about the window and its views, about manual control, parameters and plots,
/// about color tables, and about games.
std::vector<CommandTable::Command> windowCatalog();
std::vector<CommandTable::Command> controlCatalog();
std::vector<CommandTable::Command> colorCatalog();
std::vector<CommandTable::Command> gameCatalog();

}  // namespace robotlink
