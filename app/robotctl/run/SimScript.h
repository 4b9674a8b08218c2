// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "app/platforms/simulated/SimulatedRun.h"

namespace app {

/// Runs a script (robotlink/commands/SCRIPTS.md) in a simulation without a window: all commands that need
/// none. The simulation is paused at first, so that a script of steps and changes does the same each time.
/// Nothing that the user keeps between runs is read or written. Prints what the script prints, and its error;
/// returns an ExitStatus.
int runSimScript(const RunOptions& options, const std::filesystem::path& script);

}  // namespace app
