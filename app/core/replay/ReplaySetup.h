// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "robotcontrol/Logging.pb.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/config/RobotUse.h"
#include "robotlink/debugging/SolutionParameters.h"
#include "robotlink/process/Layout.h"

namespace robotlink {
struct GroundMap;
}

namespace app {

/// What a logged robot is and what program runs on it: as the log says, or as shipped where it does not.
struct ReplaySetup {
  robotlink::Layout layout;  ///< with the solutions that were chosen when it was recorded, if it is the log's
  bool layoutFromLog = false;
  robotcontrol::ProgramSetup files;  ///< layout, description and field, as texts
  std::string team;
  std::shared_ptr<const robotlink::RobotDescription> description;
  robotlink::RobotUse use;
  std::shared_ptr<const robotlink::FieldDescription> field;
  std::shared_ptr<const robotlink::GroundMap> map = {};  ///< that it drove by; null: none is in the log
  robotlink::ParameterSource parameters;
  std::vector<std::string> notes;  ///< what of the log could not be used, and what is taken instead
};

/// `logged`: null if the log does not tell what ran on its robot; then a shipped robot of its name is taken,
/// else the ERS-210. The same if what it tells cannot be read (a newer program wrote it): a log can be played
/// in any case. `layout`: a file instead of the log's layout, whose solutions then count; empty: the log's,
/// else the shipped "compact".
tl::expected<ReplaySetup, robotlink::Errors> readReplaySetup(const robotcontrol::ProgramSetup* logged,
                                                             const std::string& robot,
                                                             const std::filesystem::path& layout);

/// A layout that computes nothing, for logs whose own cannot be run any more.
robotlink::Layout emptyLayout(const robotlink::Layout& instead);

/// Whether two set-ups are of different programs; else only solutions and parameters were changed while it
/// ran.
bool isAnotherProgram(const robotcontrol::ProgramSetup& one, const robotcontrol::ProgramSetup& other);

}  // namespace app
