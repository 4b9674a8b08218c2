// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#if defined(__SSE2__)
#include <immintrin.h>
#endif

// Eight floats at once, only for the kernels. Everything here has internal
// linkage, because the same code is compiled once for AVX2 and once for any
// processor. Only operations that IEEE 754 rounds correctly are used, no fused
// or approximate ones, so both give the same bits.
//
// Lane i holds the value of the i-th pixel, vertex or triangle of a group.
// Masks are Int8 with all bits of a lane set or none, so they select with `mask
// ? a : b` and combine with & | ~.
namespace simcore::rendering {
namespace {

// Kernels must be inlined into the functions compiled with the right
// instructions.
#define SIMCORE_INLINE inline __attribute__((always_inline, unused))

/// Vectors of the compiler's extension; comparisons give masks with -1 for
/// true.
// An operation on these compiles to one instruction with AVX2, and to several
// without.
using Float8 = float __attribute__((vector_size(32)));
using Int8 = std::int32_t __attribute__((vector_size(32)));
using Float4 = float __attribute__((vector_size(16)));
using Int4 = std::int32_t __attribute__((vector_size(16)));

/// Eight vectors, one a lane.
struct Vector8 {
  Float8 x, y, z;
};

/// A value in all lanes.
SIMCORE_INLINE Float8 splat(float v) {
  return Float8{v, v, v, v, v, v, v, v};
}
SIMCORE_INLINE Int8 splatInt(std::int32_t v) {
  return Int8{v, v, v, v, v, v, v, v};
}
SIMCORE_INLINE Vector8 splatVector(const float* v) {
  return {splat(v[0]), splat(v[1]), splat(v[2])};
}

/// Unaligned loads and stores.
template <typename V, typename T>
SIMCORE_INLINE V load(const T* from) {
  V v;
  __builtin_memcpy(&v, from, sizeof(V));
  return v;
}
template <typename V, typename T>
SIMCORE_INLINE void store(T* to, V v) {
  __builtin_memcpy(to, &v, sizeof(V));
}

/// The minimum or maximum in each lane; b if one of them is NaN.
SIMCORE_INLINE Float8 minimum(Float8 a, Float8 b) {
  return a < b ? a : b;
}
SIMCORE_INLINE Float8 maximum(Float8 a, Float8 b) {
  return a > b ? a : b;
}
SIMCORE_INLINE Float8 minimum(Float8 a, Float8 b, Float8 c) {
  return minimum(minimum(a, b), c);
}
SIMCORE_INLINE Float8 maximum(Float8 a, Float8 b, Float8 c) {
  return maximum(maximum(a, b), c);
}
/// Conversion to integers, toward zero.
SIMCORE_INLINE Int8 truncated(Float8 v) {
  return __builtin_convertvector(v, Int8);
}
/// Clears the sign bits.
SIMCORE_INLINE Float8 absolute(Float8 v) {
  return reinterpret_cast<Float8>(reinterpret_cast<Int8>(v) & splatInt(0x7FFFFFFF));
}
SIMCORE_INLINE Vector8 operator+(const Vector8& a, const Vector8& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
SIMCORE_INLINE Vector8 operator-(const Vector8& a, const Vector8& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
SIMCORE_INLINE Float8 dot(const Vector8& a, const Vector8& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
SIMCORE_INLINE Vector8 cross(const Vector8& a, const Vector8& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Lanes 0 to 3, lanes 4 to 7, and both together.
SIMCORE_INLINE Float4 lowHalf(Float8 v) {
  return __builtin_shufflevector(v, v, 0, 1, 2, 3);
}
SIMCORE_INLINE Float4 highHalf(Float8 v) {
  return __builtin_shufflevector(v, v, 4, 5, 6, 7);
}
SIMCORE_INLINE Float8 joined(Float4 low, Float4 high) {
  return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
}

/// A bit per lane, set where the mask is true.
SIMCORE_INLINE unsigned bits(Int8 mask) {
#if defined(__AVX2__)
  return static_cast<unsigned>(_mm256_movemask_ps(reinterpret_cast<__m256>(mask)));
#elif defined(__SSE2__)
  const auto v = reinterpret_cast<Float8>(mask);
  return static_cast<unsigned>(_mm_movemask_ps(lowHalf(v)) | _mm_movemask_ps(highHalf(v)) << 4);
#else
  unsigned result = 0;
  for (unsigned i = 0; i < 8; ++i) result |= (mask[i] < 0 ? 1U : 0U) << i;
  return result;
#endif
}

/// The same of four lanes of 64 bits.
using Mask4 = std::int64_t __attribute__((vector_size(32)));
SIMCORE_INLINE unsigned bits(Mask4 mask) {
#if defined(__AVX2__)
  return static_cast<unsigned>(_mm256_movemask_pd(reinterpret_cast<__m256d>(mask)));
#else
  unsigned result = 0;
  for (unsigned i = 0; i < 4; ++i) result |= (mask[i] < 0 ? 1U : 0U) << i;
  return result;
#endif
}

/// Correctly rounded square roots.
SIMCORE_INLINE Float8 squareRoot(Float8 v) {
#if defined(__AVX2__)
  return _mm256_sqrt_ps(v);
#elif defined(__SSE2__)
  return joined(_mm_sqrt_ps(lowHalf(v)), _mm_sqrt_ps(highHalf(v)));
#else
  for (int i = 0; i < 8; ++i) v[i] = __builtin_sqrtf(v[i]);
  return v;
#endif
}

/// Loads from[index] in each lane.
SIMCORE_INLINE Float8 gathered(const float* from, Int8 index) {
#if defined(__AVX2__)
  return _mm256_i32gather_ps(from, reinterpret_cast<__m256i>(index), 4);
#else
  Float8 v;
  for (int i = 0; i < 8; ++i) v[i] = from[index[i]];
  return v;
#endif
}

#if defined(__AVX2__)
/// For each set of lanes these lanes' numbers, one a byte.
struct LaneLists {
  std::uint64_t of[256];
  constexpr LaneLists() : of() {
    for (unsigned set = 0; set < 256; ++set) {
      unsigned shift = 0;
      for (unsigned lane = 0; lane < 8; ++lane) {
        if ((set >> lane & 1U) == 0) continue;
        of[set] |= static_cast<std::uint64_t>(lane) << shift;
        shift += 8;
      }
    }
  }
  /// The lanes of a list in front of the others.
  SIMCORE_INLINE __m256i moved(Int8 v, unsigned set) const {
    const __m256i order = _mm256_cvtepu8_epi32(_mm_cvtsi64_si128(static_cast<long long>(of[set])));
    return _mm256_permutevar8x32_epi32(reinterpret_cast<__m256i>(v), order);
  }
};
constexpr LaneLists kLaneLists;
#else
template <typename Number, typename Lanes>
SIMCORE_INLINE int storeEach(Number* to, Lanes v, unsigned lanes) {
  int count = 0;
  for (; lanes != 0; lanes &= lanes - 1) to[count++] = v[__builtin_ctz(lanes)];
  return count;
}
#endif
/// Stores the selected lanes one after the other and returns their number; what
/// is behind them, up to eight lanes, may be overwritten.
SIMCORE_INLINE int storeSelected(std::int32_t* to, Int8 v, unsigned lanes) {
#if defined(__AVX2__)
  store(to, kLaneLists.moved(v, lanes));
  return __builtin_popcount(lanes);
#else
  return storeEach(to, v, lanes);
#endif
}
/// The same of four lanes of 64 bits.
SIMCORE_INLINE int storeSelected(std::int64_t* to, Mask4 v, unsigned lanes) {
#if defined(__AVX2__)
  // Two lanes of 32 bits for each.
  constexpr std::uint8_t kTwice[16] = {0, 3, 12, 15, 48, 51, 60, 63, 192, 195, 204, 207, 240, 243, 252, 255};
  store(to, kLaneLists.moved(reinterpret_cast<Int8>(v), kTwice[lanes]));
  return __builtin_popcount(lanes);
#else
  return storeEach(to, v, lanes);
#endif
}

/// Loads eight bytes as integers from 0 to 255.
SIMCORE_INLINE Int8 loadBytes(const std::uint8_t* from) {
#if defined(__AVX2__)
  return reinterpret_cast<Int8>(
      _mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(from))));
#else
  return Int8{from[0], from[1], from[2], from[3], from[4], from[5], from[6], from[7]};
#endif
}
/// Stores 32 integers as bytes; those below 0 become 0 and those above 255
/// become 255.
SIMCORE_INLINE void storeClamped(std::uint8_t* to, Int8 a, Int8 b, Int8 c, Int8 d) {
#if defined(__AVX2__)
  const __m256i ab = _mm256_packs_epi32(reinterpret_cast<__m256i>(a), reinterpret_cast<__m256i>(b));
  const __m256i cd = _mm256_packs_epi32(reinterpret_cast<__m256i>(c), reinterpret_cast<__m256i>(d));
  // The halves of a vector are packed by themselves: four bytes of a, b, c, d,
  // and again.
  const __m256i order = _mm256_setr_epi32(0, 4, 1, 5, 2, 6, 3, 7);
  store(to, _mm256_permutevar8x32_epi32(_mm256_packus_epi16(ab, cd), order));
#else
  const Int8 all[4] = {a, b, c, d};
  for (int i = 0; i < 4; ++i) {
    const Int8 v = all[i];
#if defined(__SSE2__)
    const Int4 low = __builtin_shufflevector(v, v, 0, 1, 2, 3);
    const Int4 high = __builtin_shufflevector(v, v, 4, 5, 6, 7);
    const __m128i words = _mm_packs_epi32(reinterpret_cast<__m128i>(low), reinterpret_cast<__m128i>(high));
    _mm_storel_epi64(reinterpret_cast<__m128i*>(to + 8 * i), _mm_packus_epi16(words, words));
#else
    for (int k = 0; k < 8; ++k)
      to[8 * i + k] = static_cast<std::uint8_t>(v[k] < 0 ? 0 : v[k] > 255 ? 255 : v[k]);
#endif
  }
#endif
}
/// The sum of the four bytes of each lane.
SIMCORE_INLINE Int8 sumOfBytes(Int8 v) {
#if defined(__AVX2__)
  const __m256i pairs = _mm256_maddubs_epi16(reinterpret_cast<__m256i>(v), _mm256_set1_epi8(1));
  return reinterpret_cast<Int8>(_mm256_madd_epi16(pairs, _mm256_set1_epi16(1)));
#else
  return (v & 0xFF) + ((v >> 8) & 0xFF) + ((v >> 16) & 0xFF) + ((v >> 24) & 0xFF);
#endif
}

/// Transposes four vectors of eight into eight of four, stored in pairs: lane i
/// in the low half and lane i + 4 in the high half of rows[i]. It is its own
/// inverse.
struct Rows4 {
  Float8 rows[4];
};
SIMCORE_INLINE Rows4 transposed(Float8 a, Float8 b, Float8 c, Float8 d) {
  // Interleaves pairs of vectors first, then pairs of pairs. Shuffles within
  // the halves of a vector are the cheap ones with AVX2.
  const Float8 ab0 = __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13);
  const Float8 ab1 = __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15);
  const Float8 cd0 = __builtin_shufflevector(c, d, 0, 8, 1, 9, 4, 12, 5, 13);
  const Float8 cd1 = __builtin_shufflevector(c, d, 2, 10, 3, 11, 6, 14, 7, 15);
  return {{__builtin_shufflevector(ab0, cd0, 0, 1, 8, 9, 4, 5, 12, 13),
           __builtin_shufflevector(ab0, cd0, 2, 3, 10, 11, 6, 7, 14, 15),
           __builtin_shufflevector(ab1, cd1, 0, 1, 8, 9, 4, 5, 12, 13),
           __builtin_shufflevector(ab1, cd1, 2, 3, 10, 11, 6, 7, 14, 15)}};
}

/// Loads four floats from each of eight addresses: from[i][0..3] becomes lane i
/// of the four vectors.
SIMCORE_INLINE Rows4 loadTransposed(const float* const from[8]) {
  return transposed(joined(load<Float4>(from[0]), load<Float4>(from[4])),
                    joined(load<Float4>(from[1]), load<Float4>(from[5])),
                    joined(load<Float4>(from[2]), load<Float4>(from[6])),
                    joined(load<Float4>(from[3]), load<Float4>(from[7])));
}

}  // namespace
}  // namespace simcore::rendering
