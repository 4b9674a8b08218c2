// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace app {

/// The exit status of all programs of this project; kDoneWithLosses: done, but some input could not be read,
/// or the program of a robot crashed, did not return or was stopped.
enum ExitStatus { kDone = 0, kFailed = 1, kUsage = 2, kDoneWithLosses = 3 };

}  // namespace app
