// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/commands/CommandCompletion.h"

#include <algorithm>
#include <filesystem>

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

/// The files that a path can become. Hidden ones only if its name begins with a dot.
std::vector<std::string> filesOf(const std::string& begun) {
  constexpr std::size_t kMaxFiles = 500;
  const std::string folder = begun.substr(0, begun.rfind('/') + 1);
  std::vector<std::string> files;
  std::error_code failed;
  for (std::filesystem::directory_iterator it(folder.empty() ? "." : folder, failed), end;
       !failed && it != end && files.size() < kMaxFiles; it.increment(failed)) {
    const std::string name = it->path().filename().string();
    const std::string file = folder + name;
    std::error_code ignored;
    if (file.starts_with(begun) && (!name.starts_with('.') || file.substr(0, begun.size()) != folder))
      files.push_back(it->is_directory(ignored) ? file + '/' : file);
  }
  return files;
}

std::vector<std::string> textsOf(const CommandTable::Command& command, const std::vector<std::string>& before,
                                 const std::string& begun) {
  const std::size_t argument = before.size();
  const CommandTable::Argument& wanted = command.arguments[argument];
  if (wanted.type == CommandTable::Type::kBool) return {"off", "on"};
  std::vector<std::string> texts = wanted.choices;
  if (command.offer) {
    for (std::string& text : command.offer(before)) texts.push_back(std::move(text));
  }
  return wanted.type >= CommandTable::Type::kFile && texts.empty() ? filesOf(begun) : texts;
}

/// The words that represent arguments by their order; `named` becomes the argument that the last word names,
/// whose value is typed next, or stays as it is.
std::vector<std::string> wordsInOrder(const CommandTable::Command& command,
                                      const std::vector<CommandWord>& words, std::size_t& named) {
  std::vector<std::string> texts;
  for (std::size_t at = 1; at < words.size(); ++at) {
    const std::size_t argument = namedArgument(command, words[at].text);
    if (argument == command.arguments.size()) {
      texts.push_back(words[at].text);
    } else if (words[at].text.find('=') == std::string::npos && ++at == words.size()) {
      named = argument;
    }
  }
  return texts;
}

/// "--rate" for each argument that can be named.
std::vector<std::string> namedOptions(const CommandTable::Command& command) {
  std::vector<std::string> options;
  for (const CommandTable::Argument& argument : command.arguments) {
    if (argument.isOptional()) options.push_back("--" + argument.name);
  }
  return options;
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
    if (command == nullptr) return result;
    std::size_t named = command->arguments.size();
    std::vector<std::string> before = wordsInOrder(*command, typed.words, named);
    result.argument = named < command->arguments.size() ? named : before.size();
    if (begun.starts_with("--") && named == command->arguments.size()) {
      texts = namedOptions(*command);
    } else if (result.argument < command->arguments.size()) {
      result.command = command;
      // An offer of texts asks which arguments were before.
      before.resize(result.argument);
      texts = textsOf(*command, before, begun);
    }
  }
  std::ranges::sort(texts);
  texts.erase(std::unique(texts.begin(), texts.end()), texts.end());
  for (const std::string& text : texts) {
    if (text.starts_with(begun)) result.candidates.push_back(quotedWord(text));
  }
  return result;
}

}  // namespace robotlink
