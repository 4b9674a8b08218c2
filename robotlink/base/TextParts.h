// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// Reading a text part by part, joining parts, and searching lists of texts.
namespace robotlink {

/// The text without blanks at its ends: spaces, tabs and carriage returns.
inline std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r";
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

/// The texts of a range with a separator between them.
template <typename Range>
std::string joined(const Range& texts, std::string_view separator = ", ") {
  std::string all;
  bool isFirst = true;
  for (const auto& text : texts) {
    if (!std::exchange(isFirst, false)) all += separator;
    all += text;
  }
  return all;
}

inline bool contains(const std::vector<std::string>& texts, std::string_view text) {
  return std::find(texts.begin(), texts.end(), text) != texts.end();
}

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
