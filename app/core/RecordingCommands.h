// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace robotlink {
class CommandTable;
}

namespace app {

class OpenPlatform;

/// Attaches the commands for recording: recording.start, recording.save-last, recording.streams and so on.
/// What is open must outlive the command table. They fail at once, with the reason, if something is
/// impossible.
void addRecordingCommands(robotlink::CommandTable& commands, OpenPlatform& open);

}  // namespace app
