// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/commands/CommandTable.h"

namespace app {

class OpenPlatform;

/// Attaches the commands that connect remote robots, and offer the session to others. `open` must outlive
/// the table.
void addRemoteCommands(robotlink::CommandTable& commands, OpenPlatform& open);

}  // namespace app
