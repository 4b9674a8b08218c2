// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/robotctl/ColorCommands.h"
#include "app/robotctl/Commands.h"

namespace app {

ClassNames defaultClassNames() {
  const auto& names = colortool::ColorTableFile::kBHuman2009Classes;
  return {names.begin(), names.end()};
}

std::string className(const ClassNames& names, int colorClass) {
  if (colorClass == 0) return "none";
  return colorClass <= static_cast<int>(names.size()) ? names[static_cast<std::size_t>(colorClass) - 1]
                                                      : std::to_string(colorClass);
}

int classNumber(const ClassNames& names, const std::string& name) {
  const auto found = std::ranges::find(names, name);
  return found == names.end() ? 0 : static_cast<int>(found - names.begin()) + 1;
}

colortool::ColorTable singleTable(const colortool::ColorTableFile& file) {
  std::vector<std::uint8_t> same(256);
  for (std::size_t i = 0; i < same.size(); ++i) same[i] = static_cast<std::uint8_t>(i);
  return colortool::ColorTable::translated(file.singleClasses(), same);
}

void addColorCommand(CLI::App& app, int& status) {
  CLI::App* color = app.add_subcommand("color", "Makes, scores, shows and compares colour tables");
  color->require_subcommand(1);
  addColorTrainCommand(*color, status);
  addColorEvaluateCommand(*color, status);
  addColorTableCommands(*color, status);
}

}  // namespace app
