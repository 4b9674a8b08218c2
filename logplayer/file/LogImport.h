// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>

#include "logplayer/base/ImportOptions.h"
#include "logplayer/base/ImportReport.h"
#include "robotlink/base/Error.h"

namespace logplayer {

/// Whether importLog() reads a file: a log of an older format or a video, judged by its contents, or a folder
/// of pictures.
bool canImport(const std::filesystem::path& file);

/// Whether a robot may have this name, which becomes a part of stream paths ("<robot>/..."): letters, digits,
/// '-', '_' and '.'.
bool isRobotName(std::string_view name);

/// Converts a log of an older format, a video or a folder of pictures into a new MCAP file, which must not
/// exist. The new log begins with the setup of a program that fits it: the robot (resources/robots/nao.yaml,
/// or camera.yaml, whose pose is stated there), a field, and a layout of tasks that the data allows. If
/// canceled by the progress callback (error id "log.given-up"), or failed, nothing is left.
robotlink::Result<ImportReport> importLog(const std::filesystem::path& from, const std::filesystem::path& to,
                                          const ImportOptions& options);

}  // namespace logplayer
