// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace app {

class Workbench;

/// Attaches the commands that only robots with an ARCOS controller fulfill: the gripper and digital outputs
/// of the selected robot, whose driver refuses them if it has none of these.
void addPioneerCommands(Workbench& workbench);

}  // namespace app
