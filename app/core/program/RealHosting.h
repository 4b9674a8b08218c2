// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "robotlink/base/Error.h"

namespace robotcontrol {
class HostProgram;
}

namespace app {

/// Why it cannot be chosen where the program of a real robot runs; nothing if it can. `asked` is the robot
/// that a request names, empty for all.
robotlink::Errors refusalOfHosting(const std::string& robot, const std::string& asked,
                                   const robotcontrol::HostProgram& choice, bool isSpread);

}  // namespace app
