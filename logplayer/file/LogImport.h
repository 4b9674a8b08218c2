// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "logplayer/base/ImportReport.h"
#include "robotlink/base/Error.h"

namespace robotcontrol {
class ColorTable;
}

namespace logplayer {

/// Whether importLog() reads a file: a log of an older format or a video, judged by its contents, or a folder
/// of pictures.
bool canImport(const std::filesystem::path& file);

/// Whether a robot may have this name, which becomes a part of stream paths ("<robot>/..."): letters, digits,
/// '-', '_' and '.'.
bool isRobotName(std::string_view name);

/// What the imported file does not say.
struct ImportOptions {
  /// Name of the robot, see isRobotName(); empty: the default of the format, "nao" or "camera".
  std::string robot = {};
  /// Is written into the log as its color table (app/core/program/ColorTables.h reads such files); null:
  /// none.
  std::shared_ptr<const robotcontrol::ColorTable> colorTable = {};
  /// Called with the share done in [0, 1]; false cancels the import.
  std::function<bool(double)> progress = {};
};

/// Converts a log of an older format, a video or a folder of pictures into a new MCAP file, which must not
/// exist. The new log begins with the setup of a program that fits it: the robot (resources/robots/nao.yaml,
/// or camera.yaml, whose pose is stated there), a field, and a layout of tasks that the data allows. If
/// canceled by the progress callback (error id "log.given-up"), or failed, nothing is left.
robotlink::Result<ImportReport> importLog(const std::filesystem::path& from, const std::filesystem::path& to,
                                          const ImportOptions& options);

}  // namespace logplayer
