// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace app {

class Workbench;

/// Adds the commands for recording: recording.start, recording.save-last, recording.streams and so on. The
/// workbench must outlive its command table. They fail at once, with the reason, if something is impossible.
void addRecordingCommands(Workbench& workbench);

}  // namespace app
