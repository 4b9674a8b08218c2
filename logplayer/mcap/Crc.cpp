// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/mcap/Crc.h"

#include <libdeflate.h>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace logplayer::mcap {
namespace {

// Polynomials over GF(2) modulo that of the CRC; the coefficient of x^0 is the highest bit.
constexpr std::uint32_t kPolynomial = 0xEDB88320U;
constexpr std::uint32_t kOne = 1U << 31U;
constexpr std::uint32_t kX = 1U << 30U;

constexpr std::uint32_t product(std::uint32_t a, std::uint32_t b) {
  std::uint32_t sum = 0;
  for (std::uint32_t coefficient = kOne; coefficient != 0; coefficient >>= 1U) {
    if ((a & coefficient) != 0) sum ^= b;
    b = (b & 1U) != 0 ? (b >> 1U) ^ kPolynomial : b >> 1U;
  }
  return sum;
}

constexpr std::uint32_t powerOfX(std::uint64_t exponent) {
  std::uint32_t result = kOne;
  for (std::uint32_t square = kX; exponent != 0; exponent >>= 1U) {
    if ((exponent & 1U) != 0) result = product(result, square);
    square = product(square, square);
  }
  return result;
}

#if defined(__x86_64__)
#define ROBOTCONTROL_WIDE __attribute__((target("avx512f,vpclmulqdq")))

// Gopal et al., "Fast CRC Computation for Generic Polynomials Using PCLMULQDQ Instruction", Intel 2009, with
// four of their registers in one: a block is replaced by its remainder, moved ahead by `bits`.
constexpr std::size_t kWideBytes = 64;
constexpr std::size_t kStride = 4 * kWideBytes;

/// The factors for the lower and upper half of each 128 bits.
constexpr std::uint64_t lowKey(std::uint64_t bits) {
  return std::uint64_t{powerOfX(bits + 32)} << 1U;
}
constexpr std::uint64_t highKey(std::uint64_t bits) {
  return std::uint64_t{powerOfX(bits - 32)} << 1U;
}
constexpr std::uint64_t kLowFar = lowKey(8 * kStride), kHighFar = highKey(8 * kStride);
constexpr std::uint64_t kLowNear = lowKey(8 * kWideBytes), kHighNear = highKey(8 * kWideBytes);

ROBOTCONTROL_WIDE inline __m512i carried(__m512i value, __m512i keys, __m512i onto) {
  const __m512i low = _mm512_clmulepi64_epi128(value, keys, 0x00);
  const __m512i high = _mm512_clmulepi64_epi128(value, keys, 0x11);
  return _mm512_xor_si512(_mm512_xor_si512(low, high), onto);
}

ROBOTCONTROL_WIDE inline __m512i wideKeys(std::uint64_t low, std::uint64_t high) {
  const auto l = static_cast<long long>(low);
  const auto h = static_cast<long long>(high);
  return _mm512_set_epi64(h, l, h, l, h, l, h, l);
}

ROBOTCONTROL_WIDE inline __m512i load(const std::uint8_t* from) {
  return _mm512_loadu_si512(from);
}

/// Replaces a multiple of kStride bytes by kWideBytes with the same remainder.
ROBOTCONTROL_WIDE void carryTogether(const std::uint8_t* data, std::size_t bytes, std::uint32_t before,
                                     std::uint8_t* out) {
  __m512i values[4] = {load(data), load(data + 64), load(data + 128), load(data + 192)};
  values[0] =
      _mm512_xor_si512(values[0], _mm512_zextsi128_si512(_mm_cvtsi32_si128(static_cast<int>(~before))));
  const __m512i far = wideKeys(kLowFar, kHighFar);
  for (std::size_t at = kStride; at < bytes; at += kStride) {
    for (std::size_t i = 0; i < 4; ++i) values[i] = carried(values[i], far, load(data + at + i * kWideBytes));
  }
  const __m512i near = wideKeys(kLowNear, kHighNear);
  __m512i value = values[0];
  for (std::size_t i = 1; i < 4; ++i) value = carried(value, near, values[i]);
  _mm512_storeu_si512(out, value);
}

bool hasWide() {
  static const bool has = __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("vpclmulqdq") != 0;
  return has;
}
#endif

}  // namespace

std::uint32_t crc32(Bytes bytes, std::uint32_t before) {
  if (bytes.empty()) return before;  // the library restarts at a null pointer
#if defined(__x86_64__)
  if (bytes.size() >= 2 * kStride && hasWide()) {
    const std::size_t whole = bytes.size() - bytes.size() % kStride;
    std::uint8_t together[kWideBytes];
    carryTogether(bytes.data(), whole, before, together);
    // The library inverts its initial value and its result; it must start with 0.
    const std::uint32_t crc = libdeflate_crc32(0xFFFFFFFFU, together, sizeof together);
    return crc32(bytes.subspan(whole), crc);
  }
#endif
  return libdeflate_crc32(before, bytes.data(), bytes.size());
}

std::uint32_t joinedCrc32(std::uint32_t first, std::uint32_t second, std::uint64_t secondBytes) {
  // The remainder is linear: the first piece counts as if zeros followed it. x^(2^32-1) is 1, so that the
  // number of bits may be reduced modulo 2^32-1.
  const std::uint64_t bits = (secondBytes % 0xFFFFFFFFU) * 8 % 0xFFFFFFFFU;
  return product(powerOfX(bits), first) ^ second;
}

}  // namespace logplayer::mcap
