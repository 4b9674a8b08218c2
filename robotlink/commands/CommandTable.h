// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "robotlink/base/Error.h"

namespace robotlink {

/// The table of all commands. Menus, toolbars, shortcuts, scripts and tests run them, so whatever a button
/// can do, a script can do. Commands are declared in one place (CommandCatalog.h), without their objects;
/// their handlers are attached where these are. Only in the GUI's thread. Error messages name the arguments
/// that a command takes.
class CommandTable {
 public:
  /// The value of an argument; the alternatives have the order of Type, and paths and sources are texts.
  using Value = std::variant<bool, double, std::string>;
  using Values = std::vector<Value>;
  enum class Type : std::uint8_t {
    kBool,
    kNumber,
    kText,
    /// A text that is the path of a file or folder, or a URL.
    kFile,
    /// The same, or the name of something shipped, such as a scene: a word without a dot or slash that is no
    /// file.
    kSource
  };
  /// The declaration of an argument.
  struct Argument {
    std::string name;
    Type type = Type::kText;
    std::string help = {};
    /// The value if the argument is left out; unset: it must be given, unless mayBeMissing.
    std::optional<Value> initial = {};
    /// The only texts that it may be; empty: any.
    std::vector<std::string> choices = {};
    /// Whether the handler gets fewer values if it is left out. A number before others that are given is NaN
    /// then.
    bool mayBeMissing = false;

    bool isOptional() const { return initial.has_value() || mayBeMissing; }
  };
  using Handler = std::function<Result<void>(const Values&)>;
  /// Returns the possible texts of the next argument, given those before it: names of robots, views, keys.
  using Offer = std::function<std::vector<std::string>(const std::vector<std::string>& before)>;
  /// A command and what it does.
  struct Command {
    /// A unique name: "simulation.speed".
    std::string name;
    std::string help;
    /// In this order; no optional one precedes one that must be given.
    std::vector<Argument> arguments = {};
    /// Called with the values, of the declared types. Empty: no handler is attached.
    Handler run = {};
    /// Returns what completion offers in addition to the arguments' choices; may be empty.
    Offer offer = {};
  };

  CommandTable() = default;
  explicit CommandTable(std::vector<Command> declarations);

  /// Declares a command, with or without its handler. The name must be new; a duplicate ends the program with
  /// a message.
  void add(Command command);
  /// Sets what a command does. It must be declared, and nothing attached to it yet; otherwise the program
  /// ends with a message.
  void attach(const std::string& name, Handler handler, Offer offer = {});
  /// Whether a handler was attached.
  bool isAttached(const std::string& name) const;
  /// The names of commands without a handler, which fail when they are run.
  std::vector<std::string> unattached() const;
  /// Returns null if there is no such command.
  const Command* find(const std::string& name) const;
  /// All commands, by name.
  const std::map<std::string, Command>& all() const { return commands_; }

  /// Fails if there is no such command, if number, types or choices of the arguments do not match, or if
  /// nothing is attached; otherwise returns the command's own result.
  Result<void> run(const std::string& name, const Values& arguments = {}) const;
  /// Runs one line: `simulation.speed 2`, `robot.solution ball-percept "scan-lines"`. Texts may be quoted
  /// (see CommandLine.h); bools are on/off, true/false, yes/no or 1/0; an empty line or a # comment does
  /// nothing. Arguments that may be left out can also be named: `--speed 2` or `--speed=2`, wherever they
  /// stand. Files are relative to `folder`; to that of this program if it is empty. Errors about the line
  /// have the column, in bytes from 1, in Error::where.
  Result<void> runLine(const std::string& line, const std::filesystem::path& folder = {}) const;

 private:
  /// Finds a command; the error names the nearest, or those of the same group.
  Result<const Command*> require(const std::string& name) const;

  std::map<std::string, Command> commands_;
};

/// Returns the optional argument named by a word like "--speed" or "--speed=2"; their number if none.
std::size_t namedArgument(const CommandTable::Command& command, const std::string& word);

/// The arguments of a command as people read them: "<brightness: number> [warmth: number = 0]".
std::string argumentsInWords(const CommandTable::Command& command);

}  // namespace robotlink
