// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "robotlink/base/Error.h"

namespace robotlink {

/// A word of a line, without its quotes.
struct CommandWord {
  std::string text;
  /// The position of the word in the line, in bytes from 1.
  int column = 1;
};

/// Splits a line of a script into words, separated by spaces or tabs. A word or a part of one may be quoted:
/// in '...' every character stands for itself; in "..." a backslash escapes the next character (a backslash
/// before n gives a line feed). Outside quotes a backslash is an ordinary character; a # at the start of a
/// word begins a comment. Fails, with the column, if a quote is not closed.
Result<std::vector<CommandWord>> splitCommandLine(const std::string& line);

/// The words before the end of a line that is still being typed: a quote that is open ends there.
struct UnfinishedLine {
  std::vector<CommandWord> words;
  /// Whether the end is in the last word, rather than after it.
  bool isInWord = false;
  /// Whether the end is in a comment.
  bool isInComment = false;
};
UnfinishedLine splitUnfinishedLine(const std::string& line);

/// A text as a word of a line, in quotes if it needs them.
std::string quotedWord(const std::string& text);

}  // namespace robotlink
