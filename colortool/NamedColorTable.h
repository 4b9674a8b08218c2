// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "colortool/ColorClasses.h"
#include "colortool/ColorTableFile.h"

namespace colortool {

/// Classes as text, one a line with the colour that views show it in (COLORTABLES.md).
std::string colorClassesText(const ColorClasses& classes);
/// All that is wrong is told at once, with its line. `file` is the name that errors carry.
tl::expected<ColorClasses, robotlink::Errors> parseColorClasses(std::string_view text,
                                                                const std::string& file);

/// A `.c64` table with the names of its classes, which stand in a file beside it, `NAME.c64.classes`, since
/// the format has no room for them. A table without that file is of the classes of the preset bhuman2009, as
/// the known files are. A plain value.
struct NamedColorTable {
  ColorTableFile file;
  ColorClasses classes;

  /// Classes that are numbered, but not named by the preset, are called "class 9". Fails on a broken file of
  /// names, and on one that names fewer classes than the table has.
  static tl::expected<NamedColorTable, robotlink::Errors> load(const std::filesystem::path& table);
  /// Writes both, or none. The file of names is left out, and an old one removed, for the preset's classes.
  /// Fails where there are more classes than a .c64 can number.
  robotlink::Result<void> save(const std::filesystem::path& table) const;

  /// Names the classes that the table has, but that have no name: "class 9".
  void nameAll();

  static std::filesystem::path classesFile(const std::filesystem::path& table);
};

}  // namespace colortool
