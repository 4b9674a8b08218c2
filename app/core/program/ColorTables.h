// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "robotlink/base/Error.h"

namespace robotcontrol {
class ColorTable;
}

namespace app {

/// Reads the file of a color table, a .c64 or a format of another team that colortool::importTable() knows,
/// into the message that a robot's program takes (Request.set_color_table). The names of the classes are
/// included; the source is the absolute path of the file. Errors name the file.
robotlink::Result<std::shared_ptr<robotcontrol::ColorTable>> readColorTable(
    const std::filesystem::path& file);

/// The beginning of ColorTable.source for tables that were read from a log.
inline constexpr char kOfTheLog[] = "of the log";
/// Returns a copy of a logged table whose source begins with kOfTheLog, so that users see where it is from. A
/// source that begins so already is kept.
robotcontrol::ColorTable colorTableOfLog(const robotcontrol::ColorTable& logged);

}  // namespace app
