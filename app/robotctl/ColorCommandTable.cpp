// SPDX-License-Identifier: GPL-3.0-or-later
// What is done with tables alone.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/robotctl/ColorCommands.h"
#include "app/robotctl/Commands.h"

namespace app {
namespace {

using colortool::ColorClasses;
using colortool::ColorTableFile;
using colortool::NamedColorTable;

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
    for (int bit = 0; bit < ColorTableFile::kMostOfSeveral && (cell & ColorTableFile::kSeveral) != 0; ++bit) {
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
  std::cout << result.dump(2) << "\n";
  return kDone;
}

/// The class of each cell, numbered as in `classes`.
colortool::ColorTable numberedAs(const ColorClasses& classes, const NamedColorTable& table) {
  return colortool::ColorTable::translated(table.file.singleClasses(), classNumbers(table.classes, classes));
}

int diff(const TableArguments& arguments) {
  const auto first = loadTable(arguments.table, arguments.classes),
             second = loadTable(arguments.other, arguments.classes);
  if (!first) return printErrors(first.error());
  if (!second) return printErrors(second.error());
  const ColorClasses classes = unite(first->classes, second->classes);
  const colortool::ColorTable firstTable = numberedAs(classes, *first),
                              secondTable = numberedAs(classes, *second);
  const auto before = firstTable.cells(), after = secondTable.cells();
  std::map<std::pair<std::uint8_t, std::uint8_t>, std::uint64_t> changes;
  std::uint64_t changed = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (before[i] == after[i]) continue;
    ++changes[{before[i], after[i]}];
    ++changed;
  }
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const auto& [pair, count] : changes) {
    const std::string &from = classes.name(pair.first), &to = classes.name(pair.second);
    if (arguments.json)
      list.push_back({{"from", from}, {"to", to}, {"cells", count}});
    else
      std::printf("%-12s -> %-12s %7llu cells\n", from.c_str(), to.c_str(),
                  static_cast<unsigned long long>(count));
  }
  if (arguments.json)
    std::cout << nlohmann::ordered_json{{"changed", changed}, {"changes", list}}.dump(2) << "\n";
  else
    std::printf("%llu of %zu cells differ\n", static_cast<unsigned long long>(changed), before.size());
  return kDone;
}

}  // namespace

void addColorTableCommands(CLI::App& color, int& status) {
  auto arguments = std::make_shared<TableArguments>();
  const auto add = [&](const char* name, const char* help, int (*run)(const TableArguments&)) {
    CLI::App* command = color.add_subcommand(name, help);
    addClassesOption(*command, arguments->classes,
                     "Names of the classes, in the order of their numbers, if not those beside the table");
    command->callback([arguments, &status, run] { status = run(*arguments); });
    return command;
  };
  CLI::App* infos = add("info", "Says how many cells of a colour table are of which class", info);
  infos->add_option("table", arguments->table, "A colour table (.c64)")->required();
  infos->add_flag("--json", arguments->json, "Prints JSON");
  CLI::App* differences = add("diff", "Says which cells of two colour tables differ", diff);
  differences->add_option("before", arguments->table, "A colour table (.c64)")->required();
  differences->add_option("after", arguments->other, "Another one")->required();
  differences->add_flag("--json", arguments->json, "Prints JSON");
}

}  // namespace app
