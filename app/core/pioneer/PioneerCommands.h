// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "robotlink/base/Error.h"
#include "robotlink/commands/CommandTable.h"

namespace robotcontrol {
class Request;
}

namespace app {

/// Attaches the commands that only robots with an ARCOS controller fulfill: the gripper and digital outputs.
/// `ask` sends a request to the selected robot, whose driver refuses it if it has none of these; it is called
/// when a command runs, in its thread.
void addPioneerCommands(robotlink::CommandTable& commands,
                        std::function<robotlink::Result<void>(const robotcontrol::Request&)> ask);

}  // namespace app
