// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/PlatformCommands.h"

#include "app/core/CommandValues.h"
#include "app/core/OpenPlatform.h"
#include "app/core/platform/PlatformAdapter.h"
#include "app/core/program/ShippedFiles.h"

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
                                                                 : Type::kText;
  return {field.name, type, field.help};
}

void addFormCommand(CommandTable& commands, OpenPlatform& open, const PlatformAdapter& adapter) {
  const PlatformForm form = formOf(adapter);
  if (form.command.empty()) return;
  std::vector<CommandTable::Argument> arguments;
  for (const PlatformField* field : form.arguments()) arguments.push_back(argumentOf(*field));
  commands.add(
      {form.command, form.commandHelp, std::move(arguments), [&open, &adapter](const Values& values) {
         return openChosen(open, adapter, choicesOf(formOf(adapter), values));
       }});
}

}  // namespace

void addPlatformCommands(CommandTable& commands, OpenPlatform& open) {
  for (const PlatformAdapter& adapter : platformAdapters()) {
    addFormCommand(commands, open, adapter);
    if (adapter.command == nullptr) continue;
    commands.add({adapter.command,
                  adapter.commandHelp,
                  {{"source", Type::kText, adapter.sources}},
                  [&open, &adapter](const Values& values) {
                    return openChosen(open, adapter, {.sources = {text(values, 0)}});
                  }});
  }
  commands.add({"layout.open",
                "Restarts the robots' programs in another process layout, given by its path or the name of "
                "a shipped one",
                {{"layout", Type::kText, "a layout file"}},
                [&open](const Values& values) -> Result<void> {
                  open.setLayout(layoutNamed(text(values, 0)));
                  return {};
                }});
}

}  // namespace app
