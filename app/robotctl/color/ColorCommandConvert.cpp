// SPDX-License-Identifier: GPL-3.0-or-later
// `robotctl color convert`.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <memory>

#include "app/robotctl/Commands.h"
#include "app/robotctl/color/ColorSubcommands.h"
#include "colortool/table/TableImport.h"

namespace app {
namespace {

using colortool::TableFormatName;

struct ConvertArguments {
  std::string from, to, format, colors;
  ClassNames classes;
};

const TableFormatName* findFormat(const std::string& name) {
  const auto found = std::ranges::find(colortool::tableFormats(), name, &TableFormatName::name);
  return found == colortool::tableFormats().end() ? nullptr : &*found;
}

/// Says what the new table lacks.
int printImportLosses(const std::string& file, const colortool::ImportedTable& imported) {
  if (imported.mixedCells != 0)
    std::cerr << file << ": " << imported.mixedCells << (imported.mixedCells == 1 ? " cell" : " cells")
              << " had several classes in the finer table; each got the most frequent one\n";
  if (imported.reducedCells != 0)
    std::cerr << file << ": of " << imported.reducedCells << (imported.reducedCells == 1 ? " cell" : " cells")
              << " of several classes only the first is kept, since a .c64 has room for several classes "
                 "with numbers up to "
              << colortool::ColorTableFile::kMaxOfSeveral << "\n";
  return imported.mixedCells + imported.reducedCells != 0 ? kDoneWithLosses : kDone;
}

int convert(const ConvertArguments& arguments) {
  colortool::TableImportOptions options;
  if (const TableFormatName* format = findFormat(arguments.format)) options.format = format->format;
  options.colors = arguments.colors;
  auto imported = importTable(arguments.from, options);
  if (!imported) return printErrors(imported.error());
  if (!arguments.classes.empty()) {
    auto classes = chosenClasses(arguments.classes);
    if (!classes) return printErrors({classes.error()});
    imported->table.classes = std::move(*classes);
    imported->table.nameAll();
  }
  if (const auto saved = imported->table.save(arguments.to); !saved) return printErrors({saved.error()});
  const auto title =
      std::ranges::find(colortool::tableFormats(), imported->format, &TableFormatName::format)->title;
  std::printf("%s: a table of %s, %d x %d x %d cells\n", arguments.to.c_str(), std::string(title).c_str(),
              imported->sides[0], imported->sides[1], imported->sides[2]);
  printCells(imported->table);
  std::fflush(stdout);
  return printImportLosses(arguments.to, *imported);
}

}  // namespace

void addColorConvertCommand(CLI::App& color, int& status) {
  auto arguments = std::make_shared<ConvertArguments>();
  CLI::App* command = color.add_subcommand(
      "convert",
      "Converts another team's color table to .c64, and writes a file with the names of its classes");
  command->add_option("from", arguments->from, "The other team's table, also compressed (.bz2)")->required();
  command->add_option("to", arguments->to, "The new table (.c64)")->required();
  std::vector<std::string> names;
  for (const TableFormatName& format : colortool::tableFormats()) names.emplace_back(format.name);
  command->add_option("--format", arguments->format, "Format of the table, if it is not recognized")
      ->check(CLI::IsMember(names));
  command->add_option(
      "--colors", arguments->colors,
      "tekkotsu: its classes (.col), if not the file of the same name, or the only one, next to it");
  addClassesOption(*command, arguments->classes,
                   "Names of the classes, in the order of their numbers, instead of that team's");
  command->callback([arguments, &status] { status = convert(*arguments); });
}

}  // namespace app
