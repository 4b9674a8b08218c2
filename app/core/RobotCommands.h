// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace app {

class Workbench;

/// Adds the commands for robots and their programs: robot.connect, robot.stop, robot.key, robot.goal and so
/// on. The workbench must outlive its command table. Most requests are answered later; refusals are then
/// passed to the workbench's handler of errors.
void addRobotCommands(Workbench& workbench);

}  // namespace app
