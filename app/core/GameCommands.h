// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace robotlink {
class CommandTable;
}

namespace app {

class OpenPlatform;

/// Attaches the handlers of the commands to the referee of a simulated game (game.*) to the table. The
/// platform must outlive the table.
void addGameCommands(robotlink::CommandTable& commands, OpenPlatform& open);

}  // namespace app
