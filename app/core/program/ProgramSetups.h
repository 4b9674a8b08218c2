// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Logging.pb.h"
#include "robotlink/process/Layout.h"

namespace robotlink {
class Platform;
struct SharedDebugMessage;
}  // namespace robotlink

namespace app {

class HostedProgram;
struct HostedRobot;

/// The files that a robot's program is made of. A log keeps them as texts, since they may have changed by the
/// time when it is opened.
struct ProgramFiles {
  std::filesystem::path layout;
  /// The robot description.
  std::filesystem::path description;
  /// Empty if the program has no field.
  std::filesystem::path field;
  /// The name of the executor, as returned by nameOf(ExecutorKind): "lockstep" or "threads".
  std::string executor;
};

/// Reads a layout and chooses other solutions than its own for some tasks (`solutions` maps task to
/// solution). Neither names of tasks nor of solutions are checked. Fails like robotlink::readLayout().
tl::expected<robotlink::Layout, robotlink::Errors> readLayoutWith(
    const std::filesystem::path& file, const std::map<std::string, std::string>& solutions);

/// Returns the setup of a program as it is recorded in logs: the texts of its files, solutions, parameters,
/// and the packages that come from platform and debug process. Call it before the program runs. A file that
/// cannot be read gets no text.
robotcontrol::ProgramSetup programSetup(const HostedRobot& robot, const HostedProgram& program,
                                        const robotlink::Platform& platform, const ProgramFiles& files);

/// Updates a setup from a message of the program about its solutions or parameters. Returns whether the setup
/// has changed.
bool follow(robotcontrol::ProgramSetup& setup, const robotlink::SharedDebugMessage& message);

}  // namespace app
