// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/session/CommandTable.h"

namespace app {

class OpenPlatform;

/// Adds the commands that connect robots elsewhere, and offer the session to others. `open` must outlive the
/// table.
void addRemoteCommands(robotlink::CommandTable& commands, OpenPlatform& open);

}  // namespace app
