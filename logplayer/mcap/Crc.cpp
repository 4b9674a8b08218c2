// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/mcap/Crc.h"

#include <libdeflate.h>

namespace logplayer::mcap {
namespace {

// Polynomials over GF(2) modulo the CRC's, the coefficient of x^0 in the highest bit.
constexpr std::uint32_t kPolynomial = 0xEDB88320U;
constexpr std::uint32_t kOne = 1U << 31U;
constexpr std::uint32_t kX = 1U << 30U;

std::uint32_t product(std::uint32_t a, std::uint32_t b) {
  std::uint32_t sum = 0;
  for (std::uint32_t coefficient = kOne; coefficient != 0; coefficient >>= 1U) {
    if ((a & coefficient) != 0) sum ^= b;
    b = (b & 1U) != 0 ? (b >> 1U) ^ kPolynomial : b >> 1U;
  }
  return sum;
}

std::uint32_t powerOfX(std::uint64_t exponent) {
  std::uint32_t result = kOne;
  for (std::uint32_t square = kX; exponent != 0; exponent >>= 1U) {
    if ((exponent & 1U) != 0) result = product(result, square);
    square = product(square, square);
  }
  return result;
}

}  // namespace

std::uint32_t crc32(Bytes bytes, std::uint32_t before) {
  if (bytes.empty()) return before;  // the library starts anew at a null pointer
  return libdeflate_crc32(before, bytes.data(), bytes.size());
}

std::uint32_t joinedCrc32(std::uint32_t first, std::uint32_t second, std::uint64_t secondBytes) {
  // The remainder is linear: the first stretch counts as if followed by zeros. x^(2^32-1) is 1, so that the
  // number of bits may be taken modulo that.
  const std::uint64_t bits = (secondBytes % 0xFFFFFFFFU) * 8 % 0xFFFFFFFFU;
  return product(powerOfX(bits), first) ^ second;
}

}  // namespace logplayer::mcap
