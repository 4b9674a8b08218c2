// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "colortool/NamedColorTable.h"

namespace colortool {

/// The colour tables of other teams that can be read; COLORTABLES.md describes each and says where it is
/// from.
enum class TableFormat : std::uint8_t {
  kC64,       ///< GermanTeam, B-Human
  kTekkotsu,  ///< Tekkotsu, CMPack: a threshold map of CMVision
  kUPenn,     ///< UPennalizers
  kRunswift,  ///< rUNSWift, 2005
  kNUbots     ///< NUbots, 2013
};
struct TableFormatName {
  TableFormat format;
  std::string_view name;   ///< "upenn"
  std::string_view title;  ///< for people, English
};
std::span<const TableFormatName> tableFormats();

/// A table of another team, in the cells of ours. A plain value.
struct ImportedTable {
  TableFormat format = TableFormat::kC64;
  NamedColorTable table;
  std::array<int, 3> sides{};  ///< of the table read: cells along Y and the chroma channels
  /// Cells that were of several classes, and are of the one most of their parts have now (see CellGrid).
  std::size_t mixedCells = 0;
  /// Cells of several classes that a .c64 has no room for: see ColorTableFile::Packed.
  std::size_t reducedCells = 0;
};

struct ImportOptions {
  std::optional<TableFormat> format;  ///< recognised by contents and size, if it is not said
  /// A Tekkotsu table's .col; empty: that of the same name beside it, or the only one of its folder.
  std::filesystem::path colors;
};
/// Reads a table, also a .bz2 of one. Every refusal says what was wanted, with its offset or line.
tl::expected<ImportedTable, robotlink::Errors> importTable(const std::filesystem::path& file,
                                                           const ImportOptions& options = {});
/// The same from its bytes. `file` is the name that errors carry; `colors` are a Tekkotsu table's.
tl::expected<ImportedTable, robotlink::Errors> parseTable(std::string_view bytes, const std::string& file,
                                                          std::optional<TableFormat> format = {},
                                                          const std::optional<ColorClasses>& colors = {});

}  // namespace colortool
