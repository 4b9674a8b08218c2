// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string_view>

// Reading a text part by part.
namespace robotlink {

/// Removes what is before the first `separator`, and the separator, from the text; returns what was before
/// it. Without a separator that is the whole text.
inline std::string_view takePart(std::string_view& text, char separator) {
  const std::size_t end = std::min(text.find(separator), text.size());
  const std::string_view part = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return part;
}

/// Removes the first line from the text, and returns it without its end. A text that ends with a line break
/// has no empty line behind it.
inline std::string_view takeLine(std::string_view& text) {
  return takePart(text, '\n');
}

}  // namespace robotlink
