// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>

namespace robotcontrol {
class ColorTable;
}

namespace logplayer {

/// The options of an import: information that the file itself lacks.
struct ImportOptions {
  /// Name of the robot, see isRobotName() of LogImport.h; empty: the default of the format, "nao" or
  /// "camera".
  std::string robot = {};
  /// Is written into the log as its color table (app/core/program/ColorTables.h reads such files); null:
  /// none.
  std::shared_ptr<const robotcontrol::ColorTable> colorTable = {};
  /// Called with the share done in [0, 1]; false cancels the import.
  std::function<bool(double)> progress = {};
};

}  // namespace logplayer
