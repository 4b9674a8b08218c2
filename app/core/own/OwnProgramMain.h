// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

namespace app {

/// The hidden first argument with which an executable is started to run the program of one robot, and the
/// file descriptors that it gets: the socket to its host, and the pipe for its report if it crashes.
inline constexpr char kProgramArgument[] = "--robot-program";
inline constexpr int kProgramSocket = 3, kProgramReports = 4;

/// Call this first in main() of each executable that hosts robots. If the arguments ask for the program of
/// a robot, runs it until its host has ended, and returns the status of the process; otherwise nothing.
std::optional<int> ownProgramMain(int argc, char** argv);

}  // namespace app
