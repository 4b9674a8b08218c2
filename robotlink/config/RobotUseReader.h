// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/config/RobotUse.h"
#include "robotlink/config/YamlReader.h"

namespace robotlink {

/// Reads these keys of a robot's file and notes what is wrong with them. For the readers of that file alone.
RobotUse readRobotUse(const YamlNode& root);

}  // namespace robotlink
