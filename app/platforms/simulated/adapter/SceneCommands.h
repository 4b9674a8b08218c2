// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace robotlink {
class CommandTable;
}

namespace app {

class OpenPlatform;

/// Attaches the commands about the scene of a simulation: scene.place, which places robots and the ball, and
/// scene.reload. What is open must outlive the command table.
void addSceneCommands(robotlink::CommandTable& commands, OpenPlatform& open);

}  // namespace app
