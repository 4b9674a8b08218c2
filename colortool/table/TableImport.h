// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "colortool/table/NamedColorTable.h"

namespace colortool {

/// The color table formats of other teams that can be read; COLORTABLES.md describes each and names its
/// source.
enum class TableFormat : std::uint8_t {
  kC64,       ///< GermanTeam, B-Human
  kTekkotsu,  ///< Tekkotsu, CMPack: a threshold map of CMVision
  kUPenn,     ///< UPennalizers
  kRunswift,  ///< rUNSWift, 2005
  kNUbots     ///< NUbots, 2013
};
/// The names of a format.
struct TableFormatName {
  TableFormat format;
  /// The name on command lines: "upenn".
  std::string_view name;
  /// The title that users see, in English.
  std::string_view title;
};
/// Returns all formats.
std::span<const TableFormatName> tableFormats();

/// A table of another team, converted to our cells. A plain value.
struct ImportedTable {
  TableFormat format = TableFormat::kC64;
  NamedColorTable table;
  /// The original size: cells along Y and the two chroma channels.
  std::array<int, 3> sides{};
  /// Number of cells that cover original cells of several classes; each got the most frequent one (see
  /// CellGrid).
  std::size_t mixedCells = 0;
  /// Number of cells with several classes that do not fit into a .c64: see ColorTableFile::Packed.
  std::size_t reducedCells = 0;
};

/// How importTable() reads a file.
struct TableImportOptions {
  /// Empty: recognized by contents and size.
  std::optional<TableFormat> format;
  /// The .col file of a Tekkotsu table; empty: the one of the same name beside it, or the only one in its
  /// folder.
  std::filesystem::path colors;
};
/// Reads a table, optionally compressed as .bz2. Errors say what was expected, with the offset or line.
tl::expected<ImportedTable, robotlink::Errors> importTable(const std::filesystem::path& file,
                                                           const TableImportOptions& options = {});
/// Reads a table from bytes. `file` is the name that errors carry; `colors` are the classes of a Tekkotsu
/// table.
tl::expected<ImportedTable, robotlink::Errors> parseTable(std::string_view bytes, const std::string& file,
                                                          std::optional<TableFormat> format = {},
                                                          const std::optional<ColorClasses>& colors = {});

}  // namespace colortool
