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

/// The table of all commands, behind menus, toolbars, shortcuts, scripts and tests: whatever a button can do,
/// a script can. Only in the GUI's thread. Error messages name the arguments that a command takes.
class CommandTable {
 public:
  using Value = std::variant<bool, double, std::string>;
  enum class Type : std::uint8_t { kBool, kNumber, kText };
  struct Argument {
    std::string name;
    Type type = Type::kText;
    std::string help;
  };
  struct Command {
    std::string name;  ///< "simulation.speed"
    std::string help;
    std::vector<Argument> arguments;
    std::function<Result<void>(const std::vector<Value>&)> run;
  };

  /// The name must be new; a duplicate ends the program with a message.
  void add(Command command);
  const Command* find(const std::string& name) const;
  const std::map<std::string, Command>& all() const { return commands_; }

  /// Fails if there is no such command or if number or types of the arguments do not match; otherwise returns
  /// the command's own result.
  Result<void> run(const std::string& name, const std::vector<Value>& arguments = {}) const;
  /// Runs one line: `simulation.speed 2`, `robot.solution ball-percept "scan-lines"`. Texts may be quoted
  /// (see CommandLine.h); bools are on/off, true/false, yes/no or 1/0; an empty line or a # comment does
  /// nothing.
  Result<void> runLine(const std::string& line) const;

 private:
  Result<const Command*> require(const std::string& name) const;

  std::map<std::string, Command> commands_;
};

}  // namespace robotlink
