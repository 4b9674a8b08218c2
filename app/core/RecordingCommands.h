// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace app {

class Workbench;

/// Adds the commands that record: recording.start, recording.save-last, recording.streams and so on. The
/// workbench must outlive its command table. What cannot be done is refused at once, with the reason.
void addRecordingCommands(Workbench& workbench);

}  // namespace app
