// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace app {

class Workbench;

/// Adds the commands that open logs and control their replay: log.open, log.play, log.step and so on. The
/// workbench must outlive its command table.
///
/// Seconds are those since the begin of the time line that the open logs share. What the replay itself
/// refuses (a stream that is not in the log) arrives at the workbench's handler of errors.
void addLogCommands(Workbench& workbench);

}  // namespace app
