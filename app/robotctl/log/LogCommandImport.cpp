// SPDX-License-Identifier: GPL-3.0-or-later
// `robotctl log` import and repair.
#include <CLI/CLI.hpp>
#include <iomanip>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/core/platform/JsonOutput.h"
#include "app/core/platform/RobotName.h"
#include "app/core/program/ColorTables.h"
#include "app/robotctl/log/LogInput.h"
#include "app/robotctl/log/LogSubcommands.h"
#include "logplayer/base/DamageReport.h"
#include "logplayer/base/OutputFile.h"
#include "logplayer/file/LogImport.h"
#include "logplayer/mcap/read/Reader.h"
#include "robotlink/base/Printable.h"

namespace app {
namespace {

using nlohmann::json;

struct ImportArguments {
  std::string from, to, colorTable;
  logplayer::ImportOptions options;
  bool force = false;
  bool asJson = false;
};

void printKinds(const char* head, const std::map<std::string, std::uint64_t>& kinds) {
  if (kinds.empty()) return;
  std::cout << head << "\n";
  for (const auto& [kind, count] : kinds)
    std::cout << std::setw(10) << count << "  " << robotlink::printable(kind) << "\n";
}

void printReport(const ImportArguments& arguments, const logplayer::ImportReport& report) {
  if (arguments.asJson) {
    const json object{{"file", arguments.to},
                      {"format", report.format},
                      {"messages", report.messages},
                      {"imported", report.imported},
                      {"not_understood", report.notUnderstood},
                      {"damage", report.damage}};
    std::cout << jsonOutput(object);
    return;
  }
  std::cout << arguments.to << ": " << report.messages << " messages of the " << report.format << " "
            << arguments.from << "\n";
  printKinds("imported", report.imported);
  printKinds("not understood", report.notUnderstood);
}

int import(ImportArguments& arguments) {
  const auto input = LogInput::of(arguments.from);
  if (!input) return printErrors({input.error()});
  arguments.from = input->path().string();
  if (!logplayer::canImport(arguments.from)) {
    std::error_code error;
    const bool there = std::filesystem::exists(arguments.from, error);
    return printErrors(
        {{"import.format",
          there ? "this is neither a log of an older format nor a video nor a folder of pictures"
                : "there is no such file",
          {},
          {arguments.from, 0, 0}}});
  }
  if (!arguments.colorTable.empty()) {
    auto table = readColorTable(arguments.colorTable);
    if (!table) return printErrors({table.error()});
    arguments.options.colorTable = std::move(*table);
  }
  auto output = logplayer::OutputFile::create(arguments.to, arguments.force);
  if (!output) return printErrors({output.error()});
  TerminalProgress progress;
  arguments.options.progress = progress.function();
  const auto report = logplayer::importLog(arguments.from, output->temporary(), arguments.options);
  progress.erase();
  if (!report) return printErrors({output->named(report.error())});
  if (const auto named = output->commit(); !named) return printErrors({named.error()});
  printReport(arguments, *report);
  if (report->damage.empty()) return kDone;
  return printLosses({arguments.from + ": " + report->damage});
}

int repair(ImportArguments& arguments) {
  const auto input = LogInput::of(arguments.from);
  if (!input) return printErrors({input.error()});
  arguments.from = input->path().string();
  if (logplayer::canImport(arguments.from)) {
    return printErrors(
        {{"repair.format",
          "only MCAP files are repaired; 'robotctl log import' reads what can be read of this one",
          {},
          {arguments.from, 0, 0}}});
  }
  auto output = logplayer::OutputFile::create(arguments.to, arguments.force);
  if (!output) return printErrors({output.error()});
  TerminalProgress progress;
  const auto report = logplayer::mcap::repair(arguments.from, output->temporary(), progress.function());
  progress.erase();
  if (!report) return printErrors({output->named(report.error())});
  if (const auto named = output->commit(); !named) return printErrors({named.error()});
  std::cout << arguments.to << ": " << report->messages << " messages";
  if (report->chunksLost > 0 || report->bytesLost > 0) {
    std::cout << "; lost: " << report->chunksLost << (report->chunksLost == 1 ? " chunk, " : " chunks, ")
              << report->bytesLost << (report->bytesLost == 1 ? " byte" : " bytes");
  }
  std::cout << "\n";
  return printLosses(logplayer::describeDamage(arguments.from, true, report->damage));
}

CLI::App* addImporter(CLI::App& log, const char* name, const char* help,
                      const std::shared_ptr<ImportArguments>& arguments) {
  CLI::App* command = log.add_subcommand(name, help);
  command->add_option("from", arguments->from, "The log to read; - is standard input")->required();
  command->add_option("to", arguments->to, "The MCAP file to write")->required();
  command->add_flag("--force", arguments->force, "Overwrites an existing file");
  return command;
}

}  // namespace

void addLogImportCommands(CLI::App& log, int& status) {
  auto arguments = std::make_shared<ImportArguments>();
  CLI::App* command = addImporter(
      log, "import",
      "Converts a log of an older format, a video or a folder of pictures; reports what was and was not "
      "understood",
      arguments);
  command
      ->add_option("--robot", arguments->options.robot,
                   "The name that the robot gets (default: nao, or camera)")
      ->check(robotName);
  command
      ->add_option("--color-table", arguments->colorTable,
                   "A .c64 color table to store in the log as the one in use")
      ->check(CLI::ExistingFile);
  command->add_flag("--json", arguments->asJson, "Prints one JSON object");
  command->callback([arguments, &status] { status = withResources([&] { return import(*arguments); }); });

  auto wanted = std::make_shared<ImportArguments>();
  command =
      addImporter(log, "repair", "Writes what can be read of a damaged log into a new, complete one", wanted);
  command->callback([wanted, &status] { status = repair(*wanted); });
}

}  // namespace app
