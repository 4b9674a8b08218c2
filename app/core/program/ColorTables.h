// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "robotlink/base/Error.h"

namespace robotcontrol {
class ColorTable;
}

namespace app {

/// A color table's file as a robot's program takes it (Request.set_color_table), with the names of its
/// classes and its whole path as its source: a .c64, or a table of another team that can be imported
/// (colortool::importTable). Errors name the file.
robotlink::Result<std::shared_ptr<robotcontrol::ColorTable>> readColorTable(
    const std::filesystem::path& file);

/// What the source of a table begins with that a log held for its robot.
inline constexpr char kOfTheLog[] = "of the log";
/// A table that is in a log, with a source that says so.
robotcontrol::ColorTable colorTableOfLog(const robotcontrol::ColorTable& logged);

}  // namespace app
