// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/commands/CommandTable.h"

namespace app {

class OpenPlatform;

/// Attaches the commands that look back at what robots have sent, while they continue. `open` must outlive
/// the table.
void addTimelineCommands(robotlink::CommandTable& commands, OpenPlatform& open);

}  // namespace app
