// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace app {

class Workbench;

/// Adds the commands about robots and their programs: robot.connect, robot.stop, robot.key, robot.goal and so
/// on. The workbench must outlive its command table. Refusals that come later arrive at its handler of
/// errors.
void addRobotCommands(Workbench& workbench);

}  // namespace app
