// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/commands/CommandTable.h"

namespace app {

class ChangeSteps;
class OpenPlatform;

/// Attaches the commands that look back at what robots have sent, while they continue, and the
/// one that steps to changes, also in logs. `open` and `steps` must outlive the table.
void addTimelineCommands(robotlink::CommandTable& commands, OpenPlatform& open, ChangeSteps& steps);

}  // namespace app
