// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/NaturalOrder.h"

#include <algorithm>

namespace robotlink {
namespace {

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

/// Removes the number at the beginning, and returns its digits without leading zeros.
std::string_view takeDigits(std::string_view& text) {
  const auto end =
      static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), isDigit) - text.begin());
  std::string_view digits = text.substr(0, end);
  text.remove_prefix(end);
  digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
  return digits;
}

}  // namespace

bool comesNaturallyBefore(std::string_view a, std::string_view b) {
  std::string_view left = a, right = b;
  while (!left.empty() && !right.empty()) {
    if (isDigit(left.front()) && isDigit(right.front())) {
      const std::string_view one = takeDigits(left), other = takeDigits(right);
      if (one.size() != other.size()) return one.size() < other.size();
      if (one != other) return one < other;
    } else {
      if (left.front() != right.front()) return left.front() < right.front();
      left.remove_prefix(1);
      right.remove_prefix(1);
    }
  }
  return left.empty() && right.empty() ? a < b : left.empty();
}

}  // namespace robotlink
