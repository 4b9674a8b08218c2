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
class RobotProgram;
}  // namespace robotlink

namespace app {

/// What a robot's program is made of: files that are read for it, as texts, because they may have changed
/// when a log is opened.
struct ProgramFiles {
  std::filesystem::path layout;
  std::filesystem::path description;  ///< of the robot
  std::filesystem::path field;        ///< empty: its program knows none
  std::string executor;               ///< "lockstep" or "threads"
};

/// A layout with other solutions than its own for some tasks, by their names.
tl::expected<robotlink::Layout, robotlink::Errors> readLayoutWith(
    const std::filesystem::path& file, const std::map<std::string, std::string>& solutions);

/// The set-up of a program that has not run yet. A file that cannot be read any more has no text.
robotcontrol::ProgramSetup programSetup(const robotlink::RobotProgram& program,
                                        const robotlink::Platform& platform, const ProgramFiles& files);

/// Takes over what a message of the program says of its solutions and parameters; whether anything has
/// changed.
bool follow(robotcontrol::ProgramSetup& setup, const robotcontrol::DebugMessage& message);

}  // namespace app
