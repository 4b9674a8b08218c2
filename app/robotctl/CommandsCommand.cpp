// SPDX-License-Identifier: GPL-3.0-or-later
// robotctl commands: the commands of the workbench, listed.
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/core/PlatformCommands.h"
#include "app/core/platform/JsonOutput.h"
#include "app/robotctl/Commands.h"

namespace app {
namespace {

using Command = robotlink::CommandTable::Command;
using Type = robotlink::CommandTable::Type;

void printLines(const std::vector<Command>& commands) {
  for (const Command& command : commands) {
    const std::string arguments = robotlink::argumentsInWords(command);
    std::cout << command.name << (arguments.empty() ? "" : " ") << arguments << "  " << command.help << "\n";
  }
}

nlohmann::json asJson(const robotlink::CommandTable::Argument& argument) {
  const char* type = argument.type == Type::kBool     ? "bool"
                     : argument.type == Type::kNumber ? "number"
                     : argument.type >= Type::kFile   ? "file"
                                                      : "text";
  nlohmann::json json{
      {"name", argument.name}, {"type", type}, {"help", argument.help}, {"optional", argument.isOptional()}};
  if (argument.initial) std::visit([&](const auto& value) { json["default"] = value; }, *argument.initial);
  if (!argument.choices.empty()) json["choices"] = argument.choices;
  return json;
}

void printJson(const std::vector<Command>& commands) {
  nlohmann::json list = nlohmann::json::array();
  for (const Command& command : commands) {
    nlohmann::json arguments = nlohmann::json::array();
    for (const auto& argument : command.arguments) arguments.push_back(asJson(argument));
    list.push_back({{"name", command.name}, {"help", command.help}, {"arguments", std::move(arguments)}});
  }
  std::cout << jsonOutput(list);
}

}  // namespace

void addCommandsCommand(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand(
      "commands", "Print all commands of the workbench, one per line, as scripts and --command take them");
  const auto asJson = std::make_shared<bool>(false);
  command->add_flag("--json", *asJson, "Print a JSON array, with types, defaults and choices");
  command->callback([asJson, &status] {
    status = withResources([&] {
      *asJson ? printJson(allCommands()) : printLines(allCommands());
      return kDone;
    });
  });
}

}  // namespace app
