// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "logplayer/file/LogImport.h"

namespace app {

/// A validator for options with the name of a robot: returns an error message, or an empty text.
inline std::string robotName(const std::string& name) {
  if (logplayer::isRobotName(name)) return {};
  return "'" + name + "' is not a robot name; use letters, digits, '-', '_' and '.'";
}

}  // namespace app
