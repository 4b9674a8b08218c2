// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotcontrol/ProgramWire.pb.h"
#include "robotlink/base/Error.h"
#include "robotlink/debugging/SolutionParameters.h"
#include "robotlink/debugging/TaskProcess.h"
#include "robotlink/process/Layout.h"

namespace app {

/// Everything from which a program in a process of its own is created. A plain value.
struct ProgramMaterials {
  robotlink::RobotSetup robot;
  robotlink::Layout layout;
  robotlink::ParameterSource parameters;
};

/// Reads it from the files that the host names, or from the texts of a log. Fails with all reasons.
tl::expected<ProgramMaterials, robotlink::Errors> programMaterials(const robotcontrol::WireSetup& setup);

}  // namespace app
