// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/session/CommandLine.h"

#include <optional>
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

}  // namespace

Result<std::vector<std::string>> splitCommandLine(const std::string& line) {
  std::vector<std::string> words;
  std::size_t at = 0;
  while ((at = line.find_first_not_of(kBlanks, at)) != std::string::npos && line[at] != '#') {
    std::string word;
    while (at < line.size() && kBlanks.find(line[at]) == std::string_view::npos) {
      if (line[at] != '"' && line[at] != '\'') {
        word += line[at++];
        continue;
      }
      const std::size_t opened = at;
      if (readQuoted(line, at, word)) continue;
      return failure("command.quote", "the quote at column " + std::to_string(opened + 1) + " is not closed",
                     {}, {std::to_string(opened + 1)});
    }
    words.push_back(std::move(word));
  }
  return words;
}

}  // namespace robotlink
