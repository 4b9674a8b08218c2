// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <functional>
#include <string>
#include <vector>

namespace app {

/// Starts this executable as another process with other arguments, which do not include its name. The system
/// sends the process SIGTERM when the calling thread ends, and it does not get the signals of the terminal.
/// `connect` sets up the standard streams in the new process before the executable starts: it may only make
/// calls that are safe between fork() and exec(), and returns false if that failed; the process then ends
/// with status 127. Returns the id of the process, or -1 with `errno` set.
::pid_t spawnSelf(std::vector<std::string> arguments, const std::function<bool()>& connect);

}  // namespace app
