// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "colortool/ColorTable.h"
#include "colortool/ColorTableFile.h"
#include "robotlink/base/Error.h"

namespace CLI {
class App;
}

namespace app {

// Each adds a subcommand of `robotctl color`.
void addColorTrainCommand(CLI::App& color, int& status);
void addColorEvaluateCommand(CLI::App& color, int& status);
void addColorTableCommands(CLI::App& color, int& status);

/// What the colour commands call the classes of a table: class n is names[n - 1].
using ClassNames = std::vector<std::string>;
/// Those of the known .c64 files.
ClassNames defaultClassNames();
/// "none" for 0, its number where there is no name.
std::string className(const ClassNames& names, int colorClass);
/// 0 if there is none of that name.
int classNumber(const ClassNames& names, const std::string& name);

/// A table's cells with one class each.
colortool::ColorTable singleTable(const colortool::ColorTableFile& file);

}  // namespace app
