// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "colortool/table/ColorTableFile.h"

namespace game {

/// The table that knows the colors of the game's views, by the classes of B-Human.
colortool::ColorTableFile table();
/// One that a person is still at: its classes reach farther, and some cells are of two classes.
colortool::ColorTableFile roughTable();

/// The same table as a file of another team: by a writer that shares no code with our readers.
struct ForeignTable {
  /// The name of its format on command lines, and that of its file.
  std::string format, name;
  std::string bytes;
  /// What the team calls the color of a label.
  std::map<std::uint8_t, std::string> classNames;
  /// The file of a Tekkotsu table's classes.
  std::string colors;
};
/// One of each format.
std::vector<ForeignTable> foreignTables();

}  // namespace game
