// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace robotlink {

// The characters of names in expressions, whatever the locale.
constexpr bool isDigit(char c) {
  return c >= '0' && c <= '9';
}
constexpr bool beginsName(char c) {
  return c == '_' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
constexpr bool isNameCharacter(char c) {
  return beginsName(c) || isDigit(c);
}

}  // namespace robotlink
