// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace robotlink {

/// Reads a number that is all of a text; empty if it is none, begins with a plus, or is out of the type's
/// range. "inf" and "nan" are numbers of floating-point types.
template <typename Number>
std::optional<Number> parsedNumber(std::string_view text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// Parses a number of a file that people write, in which numbers may begin with a plus.
template <typename Number>
std::optional<Number> parsedNumberWithSign(std::string_view text) {
  return parsedNumber<Number>(text.starts_with('+') ? text.substr(1) : text);
}

}  // namespace robotlink
