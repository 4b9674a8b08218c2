// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "colortool/table/ColorTable.h"
#include "colortool/table/NamedColorTable.h"
#include "robotlink/base/Error.h"

namespace CLI {
class App;
}

namespace app {

// Each of these functions adds subcommands to `robotctl color`. When one is chosen, its callback runs the
// command and sets `status`, an ExitStatus, which must outlive the parsing.
void addColorTrainCommand(CLI::App& color, int& status);
void addColorEvaluateCommand(CLI::App& color, int& status);
void addColorTableCommands(CLI::App& color, int& status);
void addColorSegmentCommand(CLI::App& color, int& status);
void addColorConvertCommand(CLI::App& color, int& status);

/// The argument of the option --classes: the name of a preset alone, or names of classes; empty if the option
/// was not given.
using ClassNames = std::vector<std::string>;
/// Adds the option --classes with this help text.
void addClassesOption(CLI::App& command, ClassNames& names, const char* help);
/// The classes of the option, or those of the preset for the real log if it was not given.
robotlink::Result<colortool::ColorClasses> chosenClasses(const ClassNames& names);
/// Loads a table with the names stored beside it, or those of the option if it was given. All classes of the
/// result have names.
tl::expected<colortool::NamedColorTable, robotlink::Errors> loadTable(const std::string& file,
                                                                      const ClassNames& names);
/// The file in a folder of labels that names their classes, in the format of the file beside a color table.
constexpr const char* kLabelClassesFile = "labels.classes";

/// The classes that this file names; nothing if there is none in the folder.
tl::expected<std::optional<colortool::ColorClasses>, robotlink::Errors> namedLabelClasses(
    const std::filesystem::path& folder);

/// Number of cells of each class; cells of several classes are counted under all their names: "orange+red".
std::map<std::string, std::uint64_t> cellCounts(const colortool::NamedColorTable& table);
/// Prints these numbers to standard output.
void printCells(const colortool::NamedColorTable& table);
/// The table with one class per cell, see ColorTableFile::singleClasses().
colortool::ColorTable singleTable(const colortool::ColorTableFile& file);

}  // namespace app
