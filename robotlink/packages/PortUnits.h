// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

namespace robotlink {

/// The unit of one number of a port. Ports whose numbers differ in it name several ("m/s, rad/s"), each for
/// an equal share of the numbers, in their order. A unit that cannot be shared out counts as a whole.
inline std::string unitOfNumber(const std::string& unit, std::size_t number, std::size_t numbers) {
  constexpr const char* kSeparator = ", ";
  std::size_t units = 1;
  for (std::size_t at = unit.find(kSeparator); at != std::string::npos; at = unit.find(kSeparator, at + 1))
    ++units;
  if (number >= numbers || numbers % units != 0) return unit;
  std::size_t start = 0;
  for (std::size_t left = number / (numbers / units); left > 0; --left)
    start = unit.find(kSeparator, start) + 2;
  return unit.substr(start, unit.find(kSeparator, start) - start);
}

}  // namespace robotlink
