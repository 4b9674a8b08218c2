// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "colortool/image/ColorClasses.h"
#include "colortool/table/CellGrid.h"
#include "robotlink/base/Error.h"

namespace colortool {

// The color tables of Tekkotsu and of CMPack, which CMVision reads: a threshold map (.tm) of class numbers
// over Y, Cb and Cr, usually 16 x 64 x 64, and a text (.col) with the names and display colors of its
// classes. COLORTABLES.md describes both.

/// Whether the bytes begin as a threshold map does.
bool isTekkotsuMap(std::string_view bytes);
/// Fails, with the offset, on an invalid header or if the number of cells is not that of the header.
robotlink::Result<CellGrid> parseTekkotsuMap(std::string_view bytes, const std::string& file);

/// Class 0 is none, whatever its name; numbers that are missing get names such as "class 3". Reports all
/// problems at once, each with its line.
tl::expected<ColorClasses, robotlink::Errors> parseTekkotsuColors(std::string_view text,
                                                                  const std::string& file);

}  // namespace colortool
