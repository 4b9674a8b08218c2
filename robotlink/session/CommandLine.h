// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "robotlink/base/Error.h"

namespace robotlink {

/// Splits a line of a script into words, separated by spaces or tabs. A word or a part of one may be quoted:
/// in '...' every character stands for itself; in "..." a backslash escapes the next character (a backslash
/// before n gives a line feed). Outside quotes a backslash is an ordinary character; a # at the start of a
/// word begins a comment. Fails if a quote is not closed.
Result<std::vector<std::string>> splitCommandLine(const std::string& line);

}  // namespace robotlink
