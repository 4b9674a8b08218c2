// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/session/CommandTable.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>

#include "robotlink/base/ParsedNumber.h"
#include "robotlink/session/CommandLine.h"

namespace robotlink {
namespace {

using Argument = CommandTable::Argument;
using Type = CommandTable::Type;
using Value = CommandTable::Value;

const char* typeName(Type type) {
  return type == Type::kBool ? "on or off" : type == Type::kNumber ? "number" : "text";
}

std::string withArticle(Type type) {
  return std::string(type == Type::kBool ? "" : "a ") + typeName(type);
}

Type typeOf(const Value& value) {
  return static_cast<Type>(value.index());
}

// The usage of a command for error messages: "simulation.speed <factor: number, times real time>".
std::string usage(const CommandTable::Command& command) {
  std::string result = command.name;
  for (const Argument& argument : command.arguments) {
    result += " <" + argument.name + ": " + typeName(argument.type);
    if (!argument.help.empty()) result += ", " + argument.help;
    result += ">";
  }
  return result;
}

tl::unexpected<Error> wrongCount(const CommandTable::Command& command, std::size_t given) {
  const std::size_t wanted = command.arguments.size();
  const std::string count = std::to_string(wanted) + (wanted == 1 ? " argument" : " arguments");
  return failure("command.argument-count",
                 command.name + " takes " + (wanted == 0 ? "no arguments" : count) + ", " +
                     std::to_string(given) + (given == 1 ? " was" : " were") + " given: " + usage(command),
                 {}, {command.name, std::to_string(wanted), std::to_string(given)});
}

tl::unexpected<Error> wrongType(const CommandTable::Command& command, const Argument& argument,
                                const std::string& given) {
  return failure("command.argument-type",
                 "the argument " + argument.name + " must be " + withArticle(argument.type) + ", not " +
                     given + ": " + usage(command),
                 {}, {command.name, argument.name, given});
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

}  // namespace

void CommandTable::add(Command command) {
  const std::string name = command.name;
  if (commands_.emplace(name, std::move(command)).second) return;
  std::fprintf(stderr, "command \"%s\": added twice; names of commands are unique\n", name.c_str());
  std::abort();
}

const CommandTable::Command* CommandTable::find(const std::string& name) const {
  const auto found = commands_.find(name);
  return found == commands_.end() ? nullptr : &found->second;
}

Result<const CommandTable::Command*> CommandTable::require(const std::string& name) const {
  if (const Command* command = find(name)) return command;
  const std::string group = name.substr(0, name.find('.') + 1);
  std::string known;
  for (auto it = commands_.lower_bound(group); !group.empty() && it != commands_.end(); ++it) {
    if (!it->first.starts_with(group)) break;
    known += (known.empty() ? "; there are " : ", ") + it->first;
  }
  return failure("command.unknown", "there is no command " + name + known, {}, {name});
}

Result<void> CommandTable::run(const std::string& name, const std::vector<Value>& arguments) const {
  const auto command = require(name);
  if (!command) return tl::unexpected(command.error());
  const auto& wanted = (*command)->arguments;
  if (arguments.size() != wanted.size()) return wrongCount(**command, arguments.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (typeOf(arguments[i]) == wanted[i].type) continue;
    return wrongType(**command, wanted[i], withArticle(typeOf(arguments[i])));
  }
  return (*command)->run(arguments);
}

Result<void> CommandTable::runLine(const std::string& line) const {
  const auto words = splitCommandLine(line);
  if (!words) return tl::unexpected(words.error());
  if (words->empty()) return {};
  const auto command = require(words->front());
  if (!command) return tl::unexpected(command.error());
  const auto& wanted = (*command)->arguments;
  if (words->size() - 1 != wanted.size()) return wrongCount(**command, words->size() - 1);
  std::vector<Value> arguments;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const auto value = parseValue(wanted[i].type, (*words)[i + 1]);
    if (!value) return wrongType(**command, wanted[i], '"' + (*words)[i + 1] + '"');
    arguments.push_back(*value);
  }
  return (*command)->run(arguments);
}

}  // namespace robotlink
