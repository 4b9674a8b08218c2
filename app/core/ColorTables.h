// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "robotlink/base/Error.h"

namespace robotcontrol {
class ColorTable;
}

namespace app {

/// A .c64 file as a robot's program takes it (Request.set_color_table), with the names of its classes
/// (colortool::NamedColorTable).
robotlink::Result<std::shared_ptr<robotcontrol::ColorTable>> readColorTable(
    const std::filesystem::path& file);

}  // namespace app
