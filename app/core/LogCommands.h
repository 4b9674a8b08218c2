// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "robotlink/base/Error.h"

namespace robotlink {
class CommandTable;
}

namespace app {

class LogWriteJob;
class OpenPlatform;

/// Attaches the commands that add logs and control their replay: log.add, log.play, log.step and so on. What
/// is open must outlive the command table.
///
/// Times are in seconds since the beginning of the timeline that the open logs share. What only the replay
/// can find wrong (a stream that is not in the log) is passed to the handler of errors later.
void addLogCommands(robotlink::CommandTable& commands, OpenPlatform& open);
/// Returns the files of the open logs. Fails if none is open.
robotlink::Result<std::vector<std::filesystem::path>> openLogs(OpenPlatform& open);
/// Attaches log.cut and log.export, which write parts of the open logs by `job`.
void addLogWriting(robotlink::CommandTable& commands, OpenPlatform& open, LogWriteJob& job);

}  // namespace app
