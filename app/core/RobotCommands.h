// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/base/Error.h"

namespace robotcontrol {
class Request;
}
namespace robotlink {
class CommandTable;
}

namespace app {

class OpenPlatform;

/// Attaches the commands for robots and their programs: robot.stop, robot.key, robot.goal and so on. What is
/// open must outlive the command table. Most requests are answered later; refusals are then passed to the
/// handler of errors.
void addRobotCommands(robotlink::CommandTable& commands, OpenPlatform& open);
/// Sends a request to the selected robot. Fails if there is no robot.
robotlink::Result<void> askSelectedRobot(OpenPlatform& open, const robotcontrol::Request& request);

}  // namespace app
