// SPDX-License-Identifier: GPL-3.0-or-later
// `robotctl color` info and diff, the commands that need only tables.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/core/platform/JsonOutput.h"
#include "app/robotctl/Commands.h"
#include "app/robotctl/color/ColorSubcommands.h"
#include "colortool/table/TableDifference.h"

namespace app {
namespace {

using colortool::ColorTableFile;
using colortool::NamedColorTable;
using colortool::TableDifference;

struct TableArguments {
  std::string table, other;
  ClassNames classes;
  bool json = false;
};

}  // namespace

std::map<std::string, std::uint64_t> cellCounts(const NamedColorTable& table) {
  std::map<std::uint8_t, std::uint64_t> counts;
  for (const std::uint8_t cell : table.file.cells) ++counts[cell];
  std::map<std::string, std::uint64_t> named;
  for (const auto& [cell, count] : counts) {
    std::string name;
    if ((cell & ColorTableFile::kSeveral) == 0) name = table.classes.name(cell);
    for (int bit = 0; bit < ColorTableFile::kMaxOfSeveral && (cell & ColorTableFile::kSeveral) != 0; ++bit) {
      if ((cell >> bit & 1) != 0) name += (name.empty() ? "" : "+") + table.classes.name(bit + 1);
    }
    named[name.empty() ? table.classes.name(0) : name] += count;
  }
  return named;
}

void printCells(const NamedColorTable& table) {
  for (const auto& [name, count] : cellCounts(table)) {
    std::printf("%-24s %7llu cells %6.2f %%\n", name.c_str(), static_cast<unsigned long long>(count),
                100 * static_cast<double>(count) / static_cast<double>(ColorTableFile::kCellCount));
  }
}

namespace {

int info(const TableArguments& arguments) {
  const auto table = loadTable(arguments.table, arguments.classes);
  if (!table) return printErrors(table.error());
  if (!arguments.json) {
    printCells(*table);
    return kDone;
  }
  const nlohmann::ordered_json result{
      {"file", arguments.table}, {"classes", table->classes.names()}, {"cells", cellCounts(*table)}};
  std::cout << jsonOutput(result);
  return kDone;
}

TableDifference difference(const NamedColorTable& before, const NamedColorTable& after) {
  return {singleTable(before.file), before.classes, singleTable(after.file), after.classes};
}

nlohmann::ordered_json jsonOf(const TableDifference& difference) {
  nlohmann::ordered_json changes = nlohmann::ordered_json::array(),
                         classes = nlohmann::ordered_json::object();
  for (int from = 0; from < difference.classes().size(); ++from) {
    const std::string& name = difference.classes().name(from);
    const TableDifference::OfClass sum = difference.ofClass(from);
    classes[name] = {
        {"before", sum.before}, {"after", sum.after}, {"gained", sum.gained}, {"lost", sum.lost}};
    for (int to = 0; to < difference.classes().size(); ++to) {
      if (from != to && difference.count(from, to) > 0)
        changes.push_back(
            {{"from", name}, {"to", difference.classes().name(to)}, {"cells", difference.count(from, to)}});
    }
  }
  return {{"changed", difference.changed()}, {"changes", changes}, {"classes", classes}};
}

void printDifference(const TableDifference& difference) {
  const auto number = [](std::uint64_t count) { return static_cast<unsigned long long>(count); };
  for (int from = 0; from < difference.classes().size(); ++from) {
    for (int to = 0; to < difference.classes().size(); ++to) {
      if (from == to || difference.count(from, to) == 0) continue;
      std::printf("%-12s -> %-12s %7llu cells\n", difference.classes().name(from).c_str(),
                  difference.classes().name(to).c_str(), number(difference.count(from, to)));
    }
  }
  std::printf("%llu of %zu cells differ\n", number(difference.changed()), ColorTableFile::kCellCount);
}

int diff(const TableArguments& arguments) {
  const auto first = loadTable(arguments.table, arguments.classes),
             second = loadTable(arguments.other, arguments.classes);
  if (!first) return printErrors(first.error());
  if (!second) return printErrors(second.error());
  const TableDifference found = difference(*first, *second);
  if (arguments.json)
    std::cout << jsonOutput(jsonOf(found));
  else
    printDifference(found);
  return kDone;
}

}  // namespace

void addColorTableCommands(CLI::App& color, int& status) {
  auto arguments = std::make_shared<TableArguments>();
  const auto add = [&](const char* name, const char* help, int (*run)(const TableArguments&)) {
    CLI::App* command = color.add_subcommand(name, help);
    addClassesOption(
        *command, arguments->classes,
        "Names of the classes, in the order of their numbers, if not from the file next to the table");
    command->callback([arguments, &status, run] { status = run(*arguments); });
    return command;
  };
  CLI::App* infos = add("info", "Counts the cells of each class in a color table", info);
  infos->add_option("table", arguments->table, "A color table (.c64)")->required();
  infos->add_flag("--json", arguments->json, "Prints JSON");
  CLI::App* differences = add("diff", "Lists the cells in which two color tables differ", diff);
  differences->add_option("before", arguments->table, "A color table (.c64)")->required();
  differences->add_option("after", arguments->other, "Another one")->required();
  differences->add_flag("--json", arguments->json, "Prints JSON");
}

}  // namespace app
