// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "logplayer/LogImport.h"

namespace app {

/// A check of an option that names a robot: what is wrong with it, or empty.
inline std::string robotName(const std::string& name) {
  if (logplayer::isRobotName(name)) return {};
  return "'" + name + "' is no name for a robot; take letters, digits, '-', '_' and '.'";
}

}  // namespace app
