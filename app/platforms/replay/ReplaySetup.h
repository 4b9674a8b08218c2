// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/core/program/HostedRobot.h"
#include "robotcontrol/Logging.pb.h"
#include "robotlink/base/Error.h"
#include "robotlink/process/Layout.h"

namespace app {

/// The description of a logged robot and of the program to run for it: from the log, or from the resources
/// where it does not. A plain value.
struct ReplaySetup {
  /// If it is the log's, with the solutions that were active in the recording.
  robotlink::Layout layout;
  /// Whether the layout is not one that the user chose.
  bool layoutFromLog = false;
  /// Layout, description and field as texts.
  robotcontrol::ProgramSetup files;
  /// Named as in the log, with the team that the log says or else that its kind has by its name; without map.
  HostedRobot robot;
  /// The parameter values that the log holds.
  std::vector<robotcontrol::ParameterValues> parameters;
  /// A sentence for each part of the log that cannot be used, with what is used instead.
  std::vector<std::string> notes;
};

/// Reads what a log says about a robot's program. `logged` is null if it says nothing; then the shipped robot
/// of this name is assumed, otherwise the ERS-210. The same holds, with a note, if it cannot be read (a newer
/// program may have written it), so that any log can be played.
///
/// `layout` is a file to be used instead of the log's layout, with that file's solutions. If it is empty and
/// the log has no layout, that of the robot's kind is used.
tl::expected<ReplaySetup, robotlink::Errors> readReplaySetup(const robotcontrol::ProgramSetup* logged,
                                                             const std::string& robot,
                                                             const std::filesystem::path& layout);

/// Returns a layout without tasks, for logs whose own can no longer be run. It keeps name and file of
/// `instead`.
robotlink::Layout emptyLayout(const robotlink::Layout& instead);

/// Whether two setups belong to different programs. If not, at most solutions and parameters were changed
/// while it ran.
bool isAnotherProgram(const robotcontrol::ProgramSetup& one, const robotcontrol::ProgramSetup& other);

}  // namespace app
