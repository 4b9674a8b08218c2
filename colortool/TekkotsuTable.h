// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "colortool/CellGrid.h"
#include "colortool/ColorClasses.h"
#include "robotlink/base/Error.h"

namespace colortool {

// The colour tables of Tekkotsu and of CMPack, which CMVision reads: a threshold map (.tm) of class numbers
// over Y, Cb and Cr, usually 16 x 64 x 64, and a text (.col) that names and shows its classes. COLORTABLES.md
// describes both.

bool isTekkotsuMap(std::string_view bytes);
/// Fails, with the offset, where the head is none or the cells are not as many as it says.
robotlink::Result<CellGrid> parseTekkotsuMap(std::string_view bytes, const std::string& file);

/// Class 0 is none, whatever it is called; numbers that are left out are called "class 3". All that is wrong
/// is told at once, with its line.
tl::expected<ColorClasses, robotlink::Errors> parseTekkotsuColors(std::string_view text,
                                                                  const std::string& file);

}  // namespace colortool
