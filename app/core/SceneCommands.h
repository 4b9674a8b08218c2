// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace robotlink {
class CommandTable;
}

namespace app {

class OpenPlatform;

/// Attaches the command that places robots and the ball of a simulation, scene.place. What is open must
/// outlive the command table.
void addSceneCommands(robotlink::CommandTable& commands, OpenPlatform& open);

}  // namespace app
