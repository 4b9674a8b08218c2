// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "robotlink/commands/CommandTable.h"

namespace robotlink {

/// The completions of the word at the cursor of a command line.
struct Completion {
  /// The part of the line that a candidate replaces: from a byte up to the cursor.
  std::size_t from = 0;
  /// Names of commands, or texts of an argument with quotes where they need them; sorted, each once.
  std::vector<std::string> candidates = {};
  /// The command whose argument is typed, and which argument, from 0; null: the command's own name.
  const CommandTable::Command* command = nullptr;
  std::size_t argument = 0;
};

/// Completes a line as runLine() reads it, at a cursor in bytes from 0. Commands without a handler are left
/// out. Arguments whose texts are not known have no candidates, but command and argument say what is wanted.
Completion complete(const CommandTable& commands, const std::string& line, std::size_t cursor);

}  // namespace robotlink
