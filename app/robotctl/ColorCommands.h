// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "colortool/ColorTable.h"
#include "colortool/NamedColorTable.h"
#include "robotlink/base/Error.h"

namespace CLI {
class App;
}

namespace app {

// Each adds a subcommand of `robotctl color`.
void addColorTrainCommand(CLI::App& color, int& status);
void addColorEvaluateCommand(CLI::App& color, int& status);
void addColorTableCommands(CLI::App& color, int& status);
void addColorSegmentCommand(CLI::App& color, int& status);
void addColorConvertCommand(CLI::App& color, int& status);

/// What the option --classes was given: the name of a preset alone, or names; empty if it was not.
using ClassNames = std::vector<std::string>;
void addClassesOption(CLI::App& command, ClassNames& names, const char* help);
/// Those, or those of the real log's preset.
robotlink::Result<colortool::ColorClasses> chosenClasses(const ClassNames& names);
/// A table with its own names, or those that were given. All its classes have names.
tl::expected<colortool::NamedColorTable, robotlink::Errors> loadTable(const std::string& file,
                                                                      const ClassNames& names);
/// Stands in a folder of labels and says what their numbers are, as the text beside a table does.
constexpr const char* kLabelClassesFile = "labels.classes";

/// The cells of each class, those of several under all their names: "orange+red".
std::map<std::string, std::uint64_t> cellCounts(const colortool::NamedColorTable& table);
/// The same for people, on the standard output.
void printCells(const colortool::NamedColorTable& table);
/// A table's cells with one class each.
colortool::ColorTable singleTable(const colortool::ColorTableFile& file);

}  // namespace app
