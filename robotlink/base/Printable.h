// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace robotlink {

/// Returns a text of another source (a robot, a client, a file) as it may be shown in one line, also by a
/// terminal, in which control characters would have effects: valid UTF-8, in which white space is a space and
/// any other control character, also those of the range C1, is '?'.
std::string printable(const std::string& text);

/// Makes a text of several lines printable, which also keeps its tabs; `indent` follows each new line.
std::string printableLines(const std::string& text, const std::string& indent = {});

/// Returns a text as it is written in XML and HTML, also in attributes: with escaped signs and new lines.
std::string escapedMarkup(const std::string& text);

}  // namespace robotlink
