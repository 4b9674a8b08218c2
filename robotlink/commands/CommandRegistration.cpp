// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/commands/CommandRegistration.h"

#include <algorithm>
#include <exception>

#include "robotlink/base/Registrations.h"
#include "robotlink/commands/CommandCatalog.h"

namespace robotlink {
namespace {

Registry<RegisteredCommand>& registered() {
  static Registry<RegisteredCommand> commands;
  return commands;
}

}  // namespace

const std::vector<RegisteredCommand>& registeredCommands() {
  return registered().all();
}

CommandRegistration::CommandRegistration(RegisteredCommand command) {
  const std::string name = command.declaration.name;
  const auto hasItsName = [&](const CommandTable::Command& other) { return other.name == name; };
  const bool isNew = std::ranges::none_of(commandCatalog(), hasItsName) &&
                     std::ranges::none_of(registeredCommands(), hasItsName, &RegisteredCommand::declaration);
  registered().add(std::move(command), "command \"" + name + "\"",
                   isNew ? "" : "there already is a command of this name");
}

void attachRegisteredCommands(CommandTable& commands, Session& session) {
  for (const RegisteredCommand& command : registeredCommands()) {
    const std::string name = command.declaration.name;
    commands.attach(name, [run = command.run, &session, name](const CommandTable::Values& values) {
      try {
        return run(session, values);
      } catch (const std::exception& thrown) {
        return Result<void>(failure("command.thrown", name + " has failed: " + thrown.what()));
      }
    });
  }
}

}  // namespace robotlink
