// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/commands/CommandTable.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "robotlink/base/ParsedNumber.h"
#include "robotlink/base/Spelling.h"
#include "robotlink/base/TextParts.h"
#include "robotlink/commands/CommandLine.h"

namespace robotlink {
namespace {

using Argument = CommandTable::Argument;
using Command = CommandTable::Command;
using Type = CommandTable::Type;
using Value = CommandTable::Value;
using Values = CommandTable::Values;

[[noreturn]] void endProgram(const std::string& name, const char* why) {
  std::fprintf(stderr, "command \"%s\": %s\n", name.c_str(), why);
  std::abort();
}

const char* typeName(Type type) {
  return type == Type::kBool     ? "on or off"
         : type == Type::kNumber ? "number"
         : type == Type::kFile   ? "file"
         : type == Type::kSource ? "file or name"
                                 : "text";
}

/// Whether it is relative to the folder, if it is not absolute.
bool isPath(Type type, const std::string& word, const std::filesystem::path& folder) {
  if (word.empty() || word.find("://") != std::string::npos) return false;
  std::error_code ignored;
  return type == Type::kFile || (type == Type::kSource && (word.find_first_of("./") != std::string::npos ||
                                                           std::filesystem::exists(folder / word, ignored)));
}

std::string withArticle(Type type) {
  return std::string(type == Type::kBool ? "" : "a ") + typeName(type);
}

Type typeOf(const Value& value) {
  return static_cast<Type>(value.index());
}

/// "logged, recomputed or automatic"
std::string alternatives(const std::vector<std::string>& names) {
  const std::vector<std::string> first(names.begin(), names.end() - 1);
  return first.empty() ? names.back() : joined(first, ", ") + " or " + names.back();
}

/// A value as it is written in a line.
std::string inLine(const Value& value) {
  if (const bool* flag = std::get_if<bool>(&value)) return *flag ? "on" : "off";
  if (const std::string* text = std::get_if<std::string>(&value)) return quotedWord(*text);
  std::array<char, 32> buffer{};
  const auto written = std::to_chars(buffer.data(), buffer.data() + buffer.size(), std::get<double>(value));
  return {buffer.data(), written.ptr};
}

std::string typeInWords(const Argument& argument) {
  return argument.choices.empty() ? typeName(argument.type) : joined(argument.choices, "|");
}

/// Describes an argument for error messages: "factor: number, times real time".
std::string describe(const Argument& argument, bool withHelp) {
  std::string text = argument.name + ": " + typeInWords(argument);
  if (argument.initial) text += " = " + inLine(*argument.initial);
  if (withHelp && !argument.help.empty()) text += ", " + argument.help;
  return argument.isOptional() ? "[" + text + "]" : "<" + text + ">";
}

std::string usage(const Command& command) {
  std::string text = command.name;
  for (const Argument& argument : command.arguments) text += " " + describe(argument, true);
  return text;
}

std::size_t countNeeded(const Command& command) {
  return static_cast<std::size_t>(
      std::ranges::count_if(command.arguments, [](const Argument& each) { return !each.isOptional(); }));
}

tl::unexpected<Error> wrongCount(const Command& command, std::size_t given, int column) {
  const std::size_t most = command.arguments.size();
  const std::size_t least = countNeeded(command);
  std::string count = "no arguments";
  if (most > 0) {
    count = (least == most ? "" : std::to_string(least) + " to ") + std::to_string(most) +
            (most == 1 ? " argument" : " arguments");
  }
  return failure("command.argument-count",
                 command.name + " takes " + count + ", " + std::to_string(given) +
                     (given == 1 ? " was" : " were") + " given: " + usage(command),
                 {{}, 0, column}, {command.name, std::to_string(most), std::to_string(given)});
}

tl::unexpected<Error> wrongType(const Command& command, const Argument& argument, const std::string& given,
                                int column) {
  const std::string wanted =
      argument.choices.empty() ? withArticle(argument.type) : alternatives(argument.choices);
  return failure(
      "command.argument-type",
      "the argument " + argument.name + " must be " + wanted + ", not " + given + ": " + usage(command),
      {{}, 0, column}, {command.name, argument.name, given});
}

std::optional<bool> parseBool(const std::string& text) {
  if (text == "on" || text == "true" || text == "yes" || text == "1") return true;
  if (text == "off" || text == "false" || text == "no" || text == "0") return false;
  return std::nullopt;
}

std::optional<Value> parseValue(Type type, const std::string& text) {
  if (type == Type::kBool) {
    const auto value = parseBool(text);
    return value ? std::optional<Value>(*value) : std::nullopt;
  }
  if (type == Type::kNumber) {
    const auto value = parsedNumber<double>(text);
    return value && std::isfinite(*value) ? std::optional<Value>(*value) : std::nullopt;
  }
  return Value(text);
}

bool isChoice(const Argument& argument, const Value& value) {
  const std::string* text = std::get_if<std::string>(&value);
  return argument.choices.empty() || text == nullptr ||
         std::ranges::find(argument.choices, *text) != argument.choices.end();
}

/// Runs a command with checked values, to which those that were left out are added.
Result<void> runComplete(const Command& command, Values values) {
  if (!command.run) {
    return failure("command.unattached",
                   command.name + " cannot be run: nothing it could act on is open here", {}, {command.name});
  }
  for (std::size_t i = values.size(); i < command.arguments.size() && command.arguments[i].initial; ++i)
    values.push_back(*command.arguments[i].initial);
  return command.run(values);
}

bool countFits(const Command& command, std::size_t given) {
  return given >= countNeeded(command) && given <= command.arguments.size();
}

/// The words of a line by the arguments for which they stand, up to the last one that is given; what is unset
/// between them has an initial value.
using Places = std::vector<std::optional<CommandWord>>;

/// Returns the first argument that has no word yet.
std::size_t firstFree(const Places& places) {
  return static_cast<std::size_t>(std::ranges::find_if(places, [](const auto& place) { return !place; }) -
                                  places.begin());
}

/// Checks what was left out, and cuts it off at the end.
Result<Places> withoutEnd(const Command& command, Places places, int column) {
  std::size_t given = 0;
  for (const auto& place : places) given += place ? 1 : 0;
  while (!places.empty() && !places.back()) places.pop_back();
  for (std::size_t i = 0; i < countNeeded(command); ++i) {
    if (i >= places.size() || !places[i]) return wrongCount(command, given, column);
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Argument& argument = command.arguments[i];
    if (places[i] || argument.initial || argument.type == Type::kNumber) continue;
    return failure("command.argument-order", argument.name + " is missing: " + usage(command),
                   {{}, 0, places.back()->column}, {command.name, argument.name});
  }
  return places;
}

/// Puts the words after the command's name to their arguments: `--rate 30` and `--rate=30` to the optional
/// one of this name, all others in their order.
Result<Places> inPlaces(const Command& command, const std::vector<CommandWord>& words) {
  Places places(command.arguments.size());
  for (std::size_t at = 1; at < words.size(); ++at) {
    CommandWord word = words[at];
    std::size_t place = namedArgument(command, word.text);
    if (place == command.arguments.size()) {
      place = firstFree(places);
      if (place == places.size()) return wrongCount(command, words.size() - 1, word.column);
    } else if (const auto equals = word.text.find('='); equals != std::string::npos) {
      word.text.erase(0, equals + 1);
    } else if (++at < words.size()) {
      word = words[at];
    } else {
      return failure("command.argument-value", word.text + " needs a value: " + usage(command),
                     {{}, 0, word.column}, {command.name, word.text});
    }
    if (places[place])
      return failure("command.argument-twice",
                     command.arguments[place].name + " is given twice: " + usage(command),
                     {{}, 0, word.column}, {command.name, command.arguments[place].name});
    places[place] = std::move(word);
  }
  return withoutEnd(command, std::move(places), words.front().column);
}

}  // namespace

CommandTable::CommandTable(std::vector<Command> declarations) {
  for (Command& command : declarations) add(std::move(command));
}

void CommandTable::add(Command command) {
  const std::string name = command.name;
  const auto& arguments = command.arguments;
  if (!std::ranges::is_partitioned(arguments, [](const Argument& each) { return !each.isOptional(); }))
    endProgram(name, "a required argument follows an optional one");
  if (!commands_.emplace(name, std::move(command)).second)
    endProgram(name, "added twice; names of commands are unique");
}

void CommandTable::attach(const std::string& name, Handler handler, Offer offer) {
  const auto found = commands_.find(name);
  if (found == commands_.end()) endProgram(name, "has a handler, but is not declared; add it to the catalog");
  if (found->second.run) endProgram(name, "has a handler already");
  found->second.run = std::move(handler);
  found->second.offer = std::move(offer);
}

bool CommandTable::isAttached(const std::string& name) const {
  const Command* command = find(name);
  return command != nullptr && command->run;
}

std::vector<std::string> CommandTable::unattached() const {
  std::vector<std::string> names;
  for (const auto& [name, command] : commands_) {
    if (!command.run) names.push_back(name);
  }
  return names;
}

const CommandTable::Command* CommandTable::find(const std::string& name) const {
  const auto found = commands_.find(name);
  return found == commands_.end() ? nullptr : &found->second;
}

Result<const CommandTable::Command*> CommandTable::require(const std::string& name) const {
  if (const Command* command = find(name)) return command;
  std::vector<std::string> all, group;
  const std::string prefix = name.substr(0, name.find('.') + 1);
  for (const auto& [known, command] : commands_) {
    all.push_back(known);
    if (!prefix.empty() && known.starts_with(prefix)) group.push_back(known);
  }
  const std::string near = nearest(name, all);
  const std::string known = !near.empty()    ? "; did you mean " + near + "?"
                            : !group.empty() ? "; there are " + joined(group, ", ")
                                             : std::string();
  return failure("command.unknown", "there is no command " + name + known, {{}, 0, 1}, {name});
}

Result<void> CommandTable::run(const std::string& name, const Values& arguments) const {
  const auto command = require(name);
  if (!command) return tl::unexpected(command.error());
  const auto& wanted = (*command)->arguments;
  if (!countFits(**command, arguments.size())) return wrongCount(**command, arguments.size(), 0);
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const Type type = std::min(wanted[i].type, Type::kText);
    if (typeOf(arguments[i]) != type)
      return wrongType(**command, wanted[i], withArticle(typeOf(arguments[i])), 0);
    if (!isChoice(wanted[i], arguments[i])) return wrongType(**command, wanted[i], inLine(arguments[i]), 0);
  }
  return runComplete(**command, arguments);
}

Result<void> CommandTable::runLine(const std::string& line, const std::filesystem::path& folder) const {
  const auto words = splitCommandLine(line);
  if (!words) return tl::unexpected(words.error());
  if (words->empty()) return {};
  auto command = require(words->front().text);
  if (!command) {
    command.error().where.column = words->front().column;
    return tl::unexpected(command.error());
  }
  const auto& wanted = (*command)->arguments;
  const auto given = inPlaces(**command, *words);
  if (!given) return tl::unexpected(given.error());
  Values values;
  for (std::size_t i = 0; i < given->size(); ++i) {
    if (!(*given)[i]) {
      values.push_back(wanted[i].initial.value_or(std::numeric_limits<double>::quiet_NaN()));
      continue;
    }
    const CommandWord& word = *(*given)[i];
    auto value = parseValue(wanted[i].type, word.text);
    if (isPath(wanted[i].type, word.text, folder)) value = (folder / word.text).string();
    if (!value || !isChoice(wanted[i], *value))
      return wrongType(**command, wanted[i], '"' + word.text + '"', word.column);
    values.push_back(*value);
  }
  return runComplete(**command, std::move(values));
}

std::size_t namedArgument(const Command& command, const std::string& word) {
  const auto& arguments = command.arguments;
  if (!word.starts_with("--")) return arguments.size();
  const std::string name = word.substr(2, word.find('=') - 2);
  const auto found = std::ranges::find_if(
      arguments, [&](const Argument& each) { return each.isOptional() && each.name == name; });
  return static_cast<std::size_t>(found - arguments.begin());
}

std::string argumentsInWords(const Command& command) {
  std::string text;
  for (const Argument& argument : command.arguments)
    text += (text.empty() ? "" : " ") + describe(argument, false);
  return text;
}

}  // namespace robotlink
