// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace app {

class Workbench;

/// Adds the commands that open logs and control their replay: log.open, log.play, log.step and so on. The
/// workbench must outlive its command table.
///
/// Times are in seconds since the beginning of the time line that the open logs share. What only the replay
/// can find wrong (a stream that is not in the log) is passed to the workbench's handler of errors later.
void addLogCommands(Workbench& workbench);

}  // namespace app
