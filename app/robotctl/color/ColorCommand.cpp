// SPDX-License-Identifier: GPL-3.0-or-later
// `robotctl color`: the command itself, and what its subcommands share.
#include <CLI/CLI.hpp>

#include "app/robotctl/Commands.h"
#include "app/robotctl/color/ColorSubcommands.h"
#include "colortool/image/ClassPresets.h"
#include "robotlink/base/AtomicFile.h"

namespace app {

using colortool::NamedColorTable;

void addClassesOption(CLI::App& command, ClassNames& names, const char* help) {
  std::string presets;
  for (const auto& preset : colortool::classPresets())
    presets += (presets.empty() ? "" : ", ") + std::string(preset.name);
  command.add_option("--classes", names, std::string(help) + ", or one of: " + presets)->delimiter(',');
}

robotlink::Result<colortool::ColorClasses> chosenClasses(const ClassNames& names) {
  return colortool::chooseClasses(names.empty() ? ClassNames{"bhuman2009"} : names);
}

tl::expected<NamedColorTable, robotlink::Errors> loadTable(const std::string& file, const ClassNames& names) {
  if (names.empty()) return NamedColorTable::load(file);
  auto classes = chosenClasses(names);
  if (!classes) return tl::unexpected(robotlink::Errors{classes.error()});
  auto table = colortool::ColorTableFile::load(file);
  if (!table) return tl::unexpected(robotlink::Errors{table.error()});
  NamedColorTable named{std::move(*table), std::move(*classes)};
  named.nameAll();
  return named;
}

tl::expected<std::optional<colortool::ColorClasses>, robotlink::Errors> namedLabelClasses(
    const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / kLabelClassesFile;
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return std::nullopt;
  const auto text = robotlink::readFile(file);
  if (!text) return tl::unexpected(robotlink::Errors{text.error()});
  auto classes = colortool::parseColorClasses(*text, file.string());
  if (!classes) return tl::unexpected(classes.error());
  return std::move(*classes);
}

colortool::ColorTable singleTable(const colortool::ColorTableFile& file) {
  std::vector<std::uint8_t> same(256);
  for (std::size_t i = 0; i < same.size(); ++i) same[i] = static_cast<std::uint8_t>(i);
  return colortool::ColorTable::translated(file.singleClasses(), same);
}

void addColorCommand(CLI::App& app, int& status) {
  CLI::App* color = app.add_subcommand("color", "Makes, scores, shows, compares and converts color tables");
  color->require_subcommand(1);
  addColorTrainCommand(*color, status);
  addColorEvaluateCommand(*color, status);
  addColorTableCommands(*color, status);
  addColorSegmentCommand(*color, status);
  addColorConvertCommand(*color, status);
}

}  // namespace app
