// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/commands/CommandCompletion.h"

#include <algorithm>

#include "robotlink/commands/CommandLine.h"

namespace robotlink {
namespace {

std::vector<std::string> namesOf(const CommandTable& commands) {
  std::vector<std::string> names;
  for (const auto& [name, command] : commands.all()) {
    if (command.run) names.push_back(name);
  }
  return names;
}

std::vector<std::string> textsOf(const CommandTable::Command& command, std::size_t argument) {
  const CommandTable::Argument& wanted = command.arguments[argument];
  if (wanted.type == CommandTable::Type::kBool) return {"off", "on"};
  std::vector<std::string> texts = wanted.choices;
  if (command.offer) {
    for (std::string& text : command.offer(argument)) texts.push_back(std::move(text));
  }
  return texts;
}

}  // namespace

Completion complete(const CommandTable& commands, const std::string& line, std::size_t cursor) {
  cursor = std::min(cursor, line.size());
  UnfinishedLine typed = splitUnfinishedLine(line.substr(0, cursor));
  Completion result{.from = cursor};
  if (typed.isInComment) return result;
  std::string begun;
  if (typed.isInWord) {
    begun = typed.words.back().text;
    result.from = static_cast<std::size_t>(typed.words.back().column - 1);
    typed.words.pop_back();
  }
  std::vector<std::string> texts;
  if (typed.words.empty()) {
    texts = namesOf(commands);
  } else {
    const CommandTable::Command* command = commands.find(typed.words.front().text);
    result.argument = typed.words.size() - 1;
    if (command == nullptr || result.argument >= command->arguments.size()) return result;
    result.command = command;
    texts = textsOf(*command, result.argument);
  }
  std::ranges::sort(texts);
  const auto [first, last] = std::ranges::unique(texts);
  texts.erase(first, last);
  for (const std::string& text : texts) {
    if (text.starts_with(begun)) result.candidates.push_back(quotedWord(text));
  }
  return result;
}

}  // namespace robotlink
