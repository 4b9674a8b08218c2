// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/table/TableImport.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "colortool/image/ClassPresets.h"
#include "colortool/table/Bzip2.h"
#include "colortool/table/CellGrid.h"
#include "colortool/table/ColorTable.h"
#include "colortool/table/OtherTeams.h"
#include "colortool/table/TekkotsuTable.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/FileSuffix.h"

namespace colortool {

using robotlink::Errors;
using robotlink::Result;

namespace {

/// More than any format's table has.
constexpr std::size_t kMaxImportedBytes = 4U << 20U;

constexpr std::array<TableFormatName, 5> kFormats = {
    {{TableFormat::kC64, "c64", "GermanTeam and B-Human"},
     {TableFormat::kTekkotsu, "tekkotsu", "Tekkotsu and CMPack"},
     {TableFormat::kUPenn, "upenn", "UPennalizers"},
     {TableFormat::kRunswift, "runswift", "rUNSWift 2005"},
     {TableFormat::kNUbots, "nubots", "NUbots 2013"}}};

tl::unexpected<Errors> refusal(std::string id, std::string text, const std::string& file) {
  return tl::unexpected(Errors{{std::move(id), std::move(text), {}, {file, 0, 0}}});
}

Result<TableFormat> recognize(std::string_view bytes, const std::string& file) {
  if (isTekkotsuMap(bytes)) return TableFormat::kTekkotsu;
  // A .c64 file can have any size, but runs that add up to a table are hardly a coincidence.
  const auto c64 = ColorTableFile::parse(bytes, file);
  if (c64) return TableFormat::kC64;
  if (bytes.size() == kUPennTable.bytes()) return TableFormat::kUPenn;
  if (bytes.size() == kRunswiftTable.bytes()) {
    // Both formats have 128 cells per side, but only the "none" of rUNSWift is not 0.
    if (bytes.find(static_cast<char>(kRunswiftTable.none)) != std::string_view::npos)
      return TableFormat::kRunswift;
    return TableFormat::kNUbots;
  }
  std::string names;
  for (const TableFormatName& format : kFormats)
    names += (names.empty() ? "" : ", ") + std::string(format.name);
  return robotlink::failure(
      "color-table.format",
      fmt::format("this is not a color table of a known format ({}): none has these {} bytes; {}", names,
                  bytes.size(), c64.error().text),
      {file, 0, 0});
}

tl::expected<ImportedTable, Errors> fromC64(std::string_view bytes, const std::string& file) {
  auto table = ColorTableFile::parse(bytes, file);
  if (!table) return tl::unexpected(Errors{table.error()});
  ImportedTable imported;
  imported.sides = {ColorTable::kCells, ColorTable::kCells, ColorTable::kCells};
  imported.table = {std::move(*table), findClassPreset("bhuman2009")->classes()};
  return imported;
}

ImportedTable ofGrid(const CellGrid& grid, ColorClasses classes) {
  RegriddedCells cells = regrid(grid);
  ImportedTable imported;
  imported.sides = grid.sides;
  imported.mixedCells = cells.mixedCells;
  imported.table = {{std::move(cells.classes)}, std::move(classes)};
  return imported;
}

tl::expected<ImportedTable, Errors> fromTekkotsu(std::string_view bytes, const std::string& file,
                                                 const std::optional<ColorClasses>& colors) {
  const auto grid = parseTekkotsuMap(bytes, file);
  if (!grid) return tl::unexpected(Errors{grid.error()});
  const auto highest = std::ranges::max_element(grid->classes);
  if (*highest > ColorTableFile::kMaxClasses) {
    return refusal("color-table.tekkotsu",
                   fmt::format("byte {} has class {}, but a .c64 only has classes up to {}",
                               bytes.size() - grid->classes.size() +
                                   static_cast<std::size_t>(highest - grid->classes.begin()),
                               int{*highest}, ColorTableFile::kMaxClasses),
                   file);
  }
  return ofGrid(*grid, colors.value_or(ColorClasses()));
}

tl::expected<ImportedTable, Errors> fromNumbers(const NumberedTable& known, std::string_view bytes,
                                                const std::string& file) {
  const auto grid = parseNumberedTable(known, bytes, file);
  if (!grid) return tl::unexpected(Errors{grid.error()});
  return ofGrid(*grid, known.classes());
}

tl::expected<ImportedTable, Errors> fromMasks(std::string_view bytes, const std::string& file) {
  if (bytes.size() != kUPennTable.bytes()) {
    return refusal("color-table.upenn",
                   fmt::format("a table of the UPennalizers has {} bytes, this has {}", kUPennTable.bytes(),
                               bytes.size()),
                   file);
  }
  std::vector<std::uint8_t> winners;
  std::vector<std::uint16_t> masks;
  for (const char byte : bytes) {
    const auto mask = static_cast<std::uint8_t>(byte);
    masks.push_back(mask);
    winners.push_back(mask == 0 ? std::uint8_t{0} : static_cast<std::uint8_t>(std::countr_zero(mask) + 1));
  }
  auto packed = ColorTableFile::pack(winners, masks);
  ImportedTable imported;
  imported.sides = kUPennTable.sides;
  imported.reducedCells = packed.reducedCells;
  imported.table = {std::move(packed.file), kUPennTable.classes()};
  return imported;
}

/// The .col file of a threshold map: the one of the same name, or the only one in its folder.
std::filesystem::path colorsBeside(const std::filesystem::path& map) {
  std::error_code error;
  std::vector<std::filesystem::path> found;
  const auto folder = map.has_parent_path() ? map.parent_path() : std::filesystem::path(".");
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    if (robotlink::fileSuffix(entry.path()) != ".col") continue;
    if (entry.path().stem() == map.stem()) return entry.path();
    found.push_back(entry.path());
  }
  return found.size() == 1 ? found.front() : std::filesystem::path();
}

tl::expected<std::optional<ColorClasses>, Errors> colorsOf(const std::filesystem::path& map,
                                                           const TableImportOptions& options) {
  const std::filesystem::path file = options.colors.empty() ? colorsBeside(map) : options.colors;
  if (file.empty()) return std::optional<ColorClasses>();
  const auto text = robotlink::readFile(file, kMaxImportedBytes);
  if (!text) return tl::unexpected(Errors{text.error()});
  auto colors = parseTekkotsuColors(*text, file.string());
  if (!colors) return tl::unexpected(colors.error());
  return std::optional<ColorClasses>(std::move(*colors));
}

}  // namespace

std::span<const TableFormatName> tableFormats() {
  return kFormats;
}

tl::expected<ImportedTable, Errors> parseTable(std::string_view bytes, const std::string& file,
                                               std::optional<TableFormat> format,
                                               const std::optional<ColorClasses>& colors) {
  std::string plain;
  if (isBzip2(bytes)) {
    auto contents = decompressBzip2(bytes, kMaxImportedBytes, file);
    if (!contents) return tl::unexpected(Errors{contents.error()});
    plain = std::move(*contents);
    bytes = plain;
  }
  if (!format) {
    const auto recognized = recognize(bytes, file);
    if (!recognized) return tl::unexpected(Errors{recognized.error()});
    format = *recognized;
  }
  auto imported = *format == TableFormat::kC64        ? fromC64(bytes, file)
                  : *format == TableFormat::kTekkotsu ? fromTekkotsu(bytes, file, colors)
                  : *format == TableFormat::kUPenn    ? fromMasks(bytes, file)
                  : *format == TableFormat::kRunswift ? fromNumbers(kRunswiftTable, bytes, file)
                                                      : fromNumbers(kNUbotsTable, bytes, file);
  if (!imported) return imported;
  imported->format = *format;
  imported->table.nameAll();
  return imported;
}

tl::expected<ImportedTable, Errors> importTable(const std::filesystem::path& file,
                                                const TableImportOptions& options) {
  const auto bytes = robotlink::readFile(file, kMaxImportedBytes);
  if (!bytes) return tl::unexpected(Errors{bytes.error()});
  // Only the maps of Tekkotsu have their classes in another file.
  const auto colors = colorsOf(file, options);
  auto imported = parseTable(*bytes, file.string(), options.format, colors ? *colors : std::nullopt);
  if (!imported) return imported;
  if (imported->format == TableFormat::kTekkotsu && !colors) return tl::unexpected(colors.error());
  std::error_code error;
  if (imported->format == TableFormat::kC64 &&
      std::filesystem::exists(NamedColorTable::classesFile(file), error)) {
    auto named = NamedColorTable::load(file);
    if (!named) return tl::unexpected(named.error());
    imported->table = std::move(*named);
  }
  return imported;
}

}  // namespace colortool
