// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/commands/CommandLine.h"

#include <string_view>

namespace robotlink {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";

// Reads the quoted part that starts at `at` into `word`; false if the line ends before the quote.
bool readQuoted(const std::string& line, std::size_t& at, std::string& word) {
  const char quote = line[at++];
  for (; at < line.size(); ++at) {
    char c = line[at];
    if (c == quote) {
      ++at;
      return true;
    }
    if (c == '\\' && quote == '"' && at + 1 < line.size()) {
      c = line[++at];
      if (c == 'n') c = '\n';
    }
    word += c;
  }
  return false;
}

/// The words of a line, and where a quote was opened that is not closed; 0: none.
struct Split {
  UnfinishedLine line;
  std::size_t openColumn = 0;
};

Split split(const std::string& line) {
  Split result;
  std::size_t at = 0;
  while ((at = line.find_first_not_of(kBlanks, at)) != std::string::npos) {
    result.line.isInWord = false;
    if (line[at] == '#') {
      result.line.isInComment = true;
      return result;
    }
    CommandWord word{{}, static_cast<int>(at) + 1};
    while (at < line.size() && kBlanks.find(line[at]) == std::string_view::npos) {
      if (line[at] != '"' && line[at] != '\'') {
        word.text += line[at++];
        continue;
      }
      const std::size_t opened = at;
      if (!readQuoted(line, at, word.text)) result.openColumn = opened + 1;
    }
    result.line.words.push_back(std::move(word));
    result.line.isInWord = at == line.size();
  }
  return result;
}

}  // namespace

Result<std::vector<CommandWord>> splitCommandLine(const std::string& line) {
  Split result = split(line);
  if (result.openColumn == 0) return std::move(result.line.words);
  const std::string column = std::to_string(result.openColumn);
  return failure("command.quote", "the quote at column " + column + " is not closed",
                 {{}, 0, static_cast<int>(result.openColumn)}, {column});
}

UnfinishedLine splitUnfinishedLine(const std::string& line) {
  return split(line).line;
}

std::string quotedWord(const std::string& text) {
  const bool isPlain =
      !text.empty() && text.front() != '#' && text.find_first_of(" \t\r\n\"'$") == std::string::npos;
  if (isPlain) return text;
  if (text.find_first_of("'\r\n") == std::string::npos) return "'" + text + "'";
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c == '\n' ? std::string("\\n") : std::string(1, c);
  }
  return quoted + '"';
}

}  // namespace robotlink
