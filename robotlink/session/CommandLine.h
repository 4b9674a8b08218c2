// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "robotlink/base/Error.h"

namespace robotlink {

/// The words of a line of a script, separated by spaces or tabs. A word or a part of one may be quoted: in
/// '...' everything stands for itself; in "..." a backslash takes the next character as it is (\n is a line
/// feed). Outside quotes a backslash stands for itself; a # at the start of a word begins a comment. Fails if
/// a quote is not closed.
Result<std::vector<std::string>> splitCommandLine(const std::string& line);

/// The word so that splitCommandLine() gives it back: quoted if it needs to be.
std::string quotedWord(const std::string& word);

}  // namespace robotlink
