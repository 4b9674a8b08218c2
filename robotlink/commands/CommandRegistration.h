// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "robotlink/commands/CommandTable.h"

namespace robotlink {

class Session;

/// A command of a plug-in, with what it does. It is in the palette, the console, scripts and
/// `robotctl commands` as all others.
struct RegisteredCommand {
  /// The declaration, without a handler.
  CommandTable::Command declaration;
  /// Called in the GUI's thread with values of the declared types. Exceptions are reported as failures.
  std::function<Result<void>(Session& session, const CommandTable::Values& values)> run;
};

/// All registered commands, in the order of registration.
const std::vector<RegisteredCommand>& registeredCommands();

/// Registers a command when it is constructed, while a plug-in is loaded. A name that another one has is
/// refused.
class [[maybe_unused]] CommandRegistration {
 public:
  explicit CommandRegistration(RegisteredCommand command);
};

/// Attaches the registered commands, which the table declares, to a session, which must outlive it.
void attachRegisteredCommands(CommandTable& commands, Session& session);

}  // namespace robotlink
