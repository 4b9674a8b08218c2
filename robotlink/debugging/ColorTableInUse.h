// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "robotcontrol/Perception.pb.h"

namespace robotlink {

/// The source of a color table that a program makes by itself, of the field's colors.
inline constexpr char kBuiltInColorTable[] = "built-in";

/// Returns the content of the stream "tables/colors" for the color table that a program uses: all but its
/// cells and its correction. Null, or without cells: the program uses the built-in one. A table without a
/// source gets one that says so.
robotcontrol::ColorTable colorTableInUse(const robotcontrol::ColorTable* table);

/// Returns "The color table is now /home/me/game.c64".
std::string describeColorTable(const robotcontrol::ColorTable& inUse);

}  // namespace robotlink
