// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <type_traits>

// Numbers of fixed width as bytes in little-endian order, as all of our file formats and wire formats have
// them.
namespace robotlink {

template <typename Number>
concept FixedWidth = std::is_arithmetic_v<Number> && !std::same_as<Number, bool>;

/// Reads a number from sizeof(Number) bytes, which need not be aligned.
template <FixedWidth Number>
Number loadNumber(const std::uint8_t* from) {
  std::array<std::uint8_t, sizeof(Number)> bytes;
  std::memcpy(bytes.data(), from, sizeof(Number));
  if constexpr (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
  return std::bit_cast<Number>(bytes);
}

/// Writes a number to sizeof(Number) bytes, which need not be aligned.
template <FixedWidth Number>
void storeNumber(std::uint8_t* to, Number number) {
  auto bytes = std::bit_cast<std::array<std::uint8_t, sizeof(Number)>>(number);
  if constexpr (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
  std::memcpy(to, bytes.data(), sizeof(Number));
}

}  // namespace robotlink
