// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/PlatformCommands.h"

#include <algorithm>
#include <set>
#include <utility>

#include "app/core/CommandValues.h"
#include "app/core/OpenPlatform.h"
#include "app/core/platform/PlatformAdapter.h"
#include "app/core/program/ShippedFiles.h"
#include "robotlink/commands/CommandCatalog.h"
#include "robotlink/commands/CommandRegistration.h"
#include "robotlink/session/RobotTeams.h"

namespace app {
namespace {

using robotlink::CommandTable;
using robotlink::Result;
using Type = CommandTable::Type;

/// Begins to open what was chosen. Fails if the choices are wrong in themselves.
Result<void> openChosen(OpenPlatform& open, const PlatformAdapter& adapter, const PlatformChoices& choices) {
  auto opening = openingOf(adapter, choices);
  if (!opening) return tl::unexpected(opening.error());
  open.open(std::move(*opening));
  return {};
}

CommandTable::Argument argumentOf(const PlatformField& field) {
  const Type type = field.kind == PlatformField::Kind::kFlag     ? Type::kBool
                    : field.kind == PlatformField::Kind::kNumber ? Type::kNumber
                    : field.kind == PlatformField::Kind::kFile   ? Type::kFile
                                                                 : Type::kText;
  CommandTable::Argument argument{field.name, type, field.help};
  // Arguments that are left out have the values of an untouched form.
  argument.mayBeMissing = !field.isSource;
  return argument;
}

/// The values of the choices of a form's argument.
CommandTable::Offer offerOf(const PlatformAdapter& adapter) {
  return [&adapter](const std::vector<std::string>& before) {
    const PlatformForm form = formOf(adapter);
    const auto& items = form.arguments()[before.size()]->items;
    std::vector<std::string> values;
    for (const PlatformField::Item& item : items ? items() : PlatformField::Items())
      values.push_back(item.value);
    return values;
  };
}

/// Returns the shipped layouts that at least one of the open robots can run.
std::vector<std::string> layoutNames(OpenPlatform& open) {
  std::set<std::string> names;
  if (const LoadedPlatform* loaded = open.loaded()) {
    for (const auto& [robot, description] : loaded->robots) {
      for (const auto& file : layoutsFor(*description)) names.insert(file.stem().string());
    }
  }
  return {names.begin(), names.end()};
}

}  // namespace

std::vector<CommandTable::Command> platformCommands() {
  std::vector<CommandTable::Command> commands;
  for (const PlatformAdapter& adapter : platformAdapters()) {
    const PlatformForm form = formOf(adapter);
    if (!form.command.empty()) {
      std::vector<CommandTable::Argument> arguments;
      for (const PlatformField* field : form.arguments()) arguments.push_back(argumentOf(*field));
      commands.push_back({form.command, form.commandHelp, std::move(arguments)});
    }
    if (adapter.command == nullptr) continue;
    commands.push_back({adapter.command, adapter.commandHelp, {{"source", Type::kSource, adapter.sources}}});
  }
  return commands;
}

std::vector<CommandTable::Command> allCommands() {
  auto commands = robotlink::commandCatalog();
  for (auto& command : platformCommands()) commands.push_back(std::move(command));
  for (const auto& command : robotlink::registeredCommands()) commands.push_back(command.declaration);
  std::ranges::sort(commands, {}, &CommandTable::Command::name);
  return commands;
}

void addPlatformCommands(CommandTable& commands, OpenPlatform& open) {
  for (const PlatformAdapter& adapter : platformAdapters()) {
    if (const std::string command = formOf(adapter).command; !command.empty()) {
      const auto openForm = [&open, &adapter](const Values& values) {
        return openChosen(open, adapter, choicesOf(formOf(adapter), values));
      };
      commands.attach(command, openForm, offerOf(adapter));
    }
    if (adapter.command == nullptr) continue;
    commands.attach(adapter.command, [&open, &adapter](const Values& values) {
      return openChosen(open, adapter, {.sources = {text(values, 0)}});
    });
  }
  commands.attach(
      "layout.open",
      [&open](const Values& values) -> Result<void> {
        open.setLayout(layoutNamed(text(values, 0)), text(values, 1));
        return {};
      },
      [&open](const auto& before) {
        if (before.empty()) return layoutNames(open);
        if (before.size() > 1) return std::vector<std::string>();
        return robotlink::robotAndTeamNames(open.session());
      });
}

}  // namespace app
