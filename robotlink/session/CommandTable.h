// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "robotlink/base/Error.h"

namespace robotlink {

/// The table of all commands. Menus, toolbars, shortcuts, scripts and tests run them, so whatever a button
/// can do, a script can do. Only in the GUI's thread. Error messages name the arguments that a command takes.
class CommandTable {
 public:
  /// The value of an argument; the alternatives have the order of Type.
  using Value = std::variant<bool, double, std::string>;
  enum class Type : std::uint8_t { kBool, kNumber, kText };
  /// The declaration of an argument.
  struct Argument {
    std::string name;
    Type type = Type::kText;
    std::string help;
  };
  /// A command and what it does.
  struct Command {
    /// A unique name: "simulation.speed".
    std::string name;
    std::string help;
    /// All arguments are required, in this order.
    std::vector<Argument> arguments;
    /// Called with as many values, of the declared types.
    std::function<Result<void>(const std::vector<Value>&)> run;
  };

  /// The name must be new; a duplicate ends the program with a message.
  void add(Command command);
  /// Returns null if there is no such command.
  const Command* find(const std::string& name) const;
  /// All commands, by name.
  const std::map<std::string, Command>& all() const { return commands_; }

  /// Fails if there is no such command or if number or types of the arguments do not match; otherwise returns
  /// the command's own result.
  Result<void> run(const std::string& name, const std::vector<Value>& arguments = {}) const;
  /// Runs one line: `simulation.speed 2`, `robot.solution ball-percept "scan-lines"`. Texts may be quoted
  /// (see CommandLine.h); bools are on/off, true/false, yes/no or 1/0; an empty line or a # comment does
  /// nothing.
  Result<void> runLine(const std::string& line) const;

 private:
  /// Finds a command; the error names those of the same group.
  Result<const Command*> require(const std::string& name) const;

  std::map<std::string, Command> commands_;
};

}  // namespace robotlink
