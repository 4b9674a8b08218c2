// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "colortool/image/ColorClasses.h"
#include "colortool/table/ColorTableFile.h"

namespace colortool {

/// Formats classes as text: one per line, with its name and display color (COLORTABLES.md).
std::string colorClassesText(const ColorClasses& classes);
/// Parses such a text and reports all problems at once, each with its line. `file` is the name that errors
/// carry.
tl::expected<ColorClasses, robotlink::Errors> parseColorClasses(std::string_view text,
                                                                const std::string& file);

/// A `.c64` table with the names of its classes, which are stored in a file beside it, `NAME.c64.classes`,
/// since the format has no room for them. A table without that file has the classes of the preset bhuman2009,
/// as all known files do. A plain value.
struct NamedColorTable {
  ColorTableFile file;
  /// The names and display colors; at least up to the highest class of the table.
  ColorClasses classes;

  /// Reads table and names. Classes that occur in the table but not in the preset get names such as "class
  /// 9". Fails on a damaged file of names, and if it names fewer classes than the table has.
  static tl::expected<NamedColorTable, robotlink::Errors> load(const std::filesystem::path& table);
  /// Writes both files, or none. For the classes of the preset the file of names is not written, and an old
  /// one is removed. Fails if there are more classes than a .c64 can number.
  robotlink::Result<void> save(const std::filesystem::path& table) const;

  /// Gives names such as "class 9" to classes that occur in the table but have none.
  void nameAll();

  /// The path of the file of names that belongs to a table.
  static std::filesystem::path classesFile(const std::filesystem::path& table);
};

}  // namespace colortool
