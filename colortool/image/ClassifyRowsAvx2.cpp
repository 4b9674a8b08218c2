// SPDX-License-Identifier: GPL-3.0-or-later
// This file is compiled for AVX2 (see CMakeLists.txt); nothing here may run before the processor has been
// checked.
#include "colortool/image/ClassifyRows.h"

#if defined(__AVX2__)
#include <immintrin.h>

namespace colortool {
namespace {

using robotlink::PixelFormat;

/// Looks up eight cells; the class is in the lowest byte of each element.
__m256i lookUp(const std::uint8_t* cells, __m256i indices) {
  const __m256i found = _mm256_i32gather_epi32(reinterpret_cast<const int*>(cells), indices, 1);
  return _mm256_and_si256(found, _mm256_set1_epi32(0xFF));
}

/// Looks up the cells of eight left and eight right pixels and interleaves the sixteen classes.
__m256i lookUpPairs(const std::uint8_t* cells, __m256i left, __m256i right) {
  return _mm256_or_si256(lookUp(cells, left), _mm256_slli_epi32(lookUp(cells, right), 8));
}

/// Packs the lower halves of two times eight elements into 32 bytes in order.
__m256i packed(__m256i first, __m256i second) {
  return _mm256_permute4x64_epi64(_mm256_packus_epi32(first, second), 0xD8);
}

__m256i loaded(const std::uint8_t* from) {
  return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from));
}

/// Each of the eight elements contains Y0 Cb Y1 Cr, the lowest byte first.
__m256i classesOfYuyv(const std::uint8_t* cells, __m256i pairs) {
  const __m256i cb = _mm256_and_si256(_mm256_srli_epi32(pairs, 4), _mm256_set1_epi32(0xFC0));
  const __m256i chroma = _mm256_or_si256(cb, _mm256_srli_epi32(pairs, 26));
  const __m256i left = _mm256_slli_epi32(_mm256_and_si256(pairs, _mm256_set1_epi32(0xFC)), 10);
  const __m256i right = _mm256_and_si256(_mm256_srli_epi32(pairs, 6), _mm256_set1_epi32(0x3F000));
  return lookUpPairs(cells, _mm256_or_si256(left, chroma), _mm256_or_si256(right, chroma));
}

/// Each of the eight elements contains Cb Y0 Cr Y1, the lowest byte first.
__m256i classesOfUyvy(const std::uint8_t* cells, __m256i pairs) {
  const __m256i cb = _mm256_slli_epi32(_mm256_and_si256(pairs, _mm256_set1_epi32(0xFC)), 4);
  const __m256i cr = _mm256_and_si256(_mm256_srli_epi32(pairs, 18), _mm256_set1_epi32(0x3F));
  const __m256i chroma = _mm256_or_si256(cb, cr);
  const __m256i left = _mm256_slli_epi32(_mm256_and_si256(pairs, _mm256_set1_epi32(0xFC00)), 2);
  const __m256i right = _mm256_and_si256(_mm256_srli_epi32(pairs, 14), _mm256_set1_epi32(0x3F000));
  return lookUpPairs(cells, _mm256_or_si256(left, chroma), _mm256_or_si256(right, chroma));
}

template <__m256i (*classesOf)(const std::uint8_t*, __m256i), PixelFormat format>
void classifyPairs(const std::uint8_t* cells, const PixelRow& row, std::uint8_t* classes) {
  int x = 0;
  for (; x + 32 <= row.width; x += 32) {
    const std::uint8_t* from = row.pixels + std::ptrdiff_t{2} * x;
    const __m256i found = packed(classesOf(cells, loaded(from)), classesOf(cells, loaded(from + 32)));
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(classes + x), found);
  }
  plainClassifyRow(format)(cells, {row.pixels + std::ptrdiff_t{2} * x, nullptr, row.width - x}, classes + x);
}

/// Sixteen pixels: eight elements contain Y0 Y1, and eight contain Cb Cr.
__m256i classesOfNv12(const std::uint8_t* cells, const std::uint8_t* luma, const std::uint8_t* chromaPairs) {
  const auto widened = [](const std::uint8_t* from) {
    return _mm256_cvtepu16_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(from)));
  };
  const __m256i y = widened(luma), c = widened(chromaPairs);
  const __m256i cb = _mm256_slli_epi32(_mm256_and_si256(c, _mm256_set1_epi32(0xFC)), 4);
  const __m256i chroma = _mm256_or_si256(cb, _mm256_srli_epi32(c, 10));
  const __m256i left = _mm256_slli_epi32(_mm256_and_si256(y, _mm256_set1_epi32(0xFC)), 10);
  const __m256i right = _mm256_slli_epi32(_mm256_and_si256(y, _mm256_set1_epi32(0xFC00)), 2);
  return lookUpPairs(cells, _mm256_or_si256(left, chroma), _mm256_or_si256(right, chroma));
}

void classifyNv12(const std::uint8_t* cells, const PixelRow& row, std::uint8_t* classes) {
  int x = 0;
  for (; x + 32 <= row.width; x += 32) {
    const __m256i found = packed(classesOfNv12(cells, row.pixels + x, row.chroma + x),
                                 classesOfNv12(cells, row.pixels + x + 16, row.chroma + x + 16));
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(classes + x), found);
  }
  plainClassifyRow(PixelFormat::kNv12)(cells, {row.pixels + x, row.chroma + x, row.width - x}, classes + x);
}

/// Like robotlink::toYCbCr(): the sum of products with R and G, and with B and 1, scaled by 2^15.
__m256i channel(__m256i redGreen, __m256i blueOne, int r, int g, int b, int offset) {
  const __m256i sum =
      _mm256_add_epi32(_mm256_madd_epi16(redGreen, _mm256_set1_epi32((g << 16) | (r & 0xFFFF))),
                       _mm256_madd_epi16(blueOne, _mm256_set1_epi32(b & 0xFFFF)));
  const __m256i value = _mm256_srai_epi32(_mm256_add_epi32(sum, _mm256_set1_epi32(offset)), 15);
  return _mm256_min_epi32(value, _mm256_set1_epi32(255));
}

/// The cells of the eight pixels at `from`, where 32 bytes are read.
template <int r, int b>
__m256i cellsOfTriples(const std::uint8_t* from) {
  // Each half contains four pixels of three bytes.
  const __m256i halves = _mm256_permutevar8x32_epi32(loaded(from), _mm256_setr_epi32(0, 1, 2, 0, 3, 4, 5, 0));
  constexpr char z = -1;
  const __m256i pickRedGreen =
      _mm256_broadcastsi128_si256(_mm_setr_epi8(r, z, 1, z, r + 3, z, 4, z, r + 6, z, 7, z, r + 9, z, 10, z));
  const __m256i pickBlue =
      _mm256_broadcastsi128_si256(_mm_setr_epi8(b, z, z, z, b + 3, z, z, z, b + 6, z, z, z, b + 9, z, z, z));
  const __m256i redGreen = _mm256_shuffle_epi8(halves, pickRedGreen);
  const __m256i blue = _mm256_shuffle_epi8(halves, pickBlue);
  constexpr int kHalf = 1 << 14, kMiddle = (128 << 15) + kHalf;
  const __m256i y = channel(redGreen, blue, 9798, 19235, 3735, kHalf);
  const __m256i cb = channel(redGreen, blue, -5529, -10855, 16384, kMiddle);
  const __m256i cr = channel(redGreen, blue, 16384, -13720, -2664, kMiddle);
  const __m256i six = _mm256_set1_epi32(0xFC);
  return _mm256_or_si256(
      _mm256_slli_epi32(_mm256_and_si256(y, six), 10),
      _mm256_or_si256(_mm256_slli_epi32(_mm256_and_si256(cb, six), 4), _mm256_srli_epi32(cr, 2)));
}

template <int r, int b, PixelFormat format>
void classifyTriples(const std::uint8_t* cells, const PixelRow& row, std::uint8_t* classes) {
  int x = 0;
  // The last load reads 8 bytes past its pixels, which must still belong to this row.
  for (; x + 32 + 3 <= row.width; x += 32) {
    const std::uint8_t* from = row.pixels + std::ptrdiff_t{3} * x;
    __m256i found[4];
    for (int i = 0; i < 4; ++i) found[i] = lookUp(cells, cellsOfTriples<r, b>(from + std::ptrdiff_t{24} * i));
    const __m256i low = _mm256_permute4x64_epi64(_mm256_packus_epi32(found[0], found[1]), 0xD8);
    const __m256i high = _mm256_permute4x64_epi64(_mm256_packus_epi32(found[2], found[3]), 0xD8);
    const __m256i bytes = _mm256_permute4x64_epi64(_mm256_packus_epi16(low, high), 0xD8);
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(classes + x), bytes);
  }
  plainClassifyRow(format)(cells, {row.pixels + std::ptrdiff_t{3} * x, nullptr, row.width - x}, classes + x);
}

}  // namespace

ClassifyRow avx2ClassifyRow(PixelFormat format) {
  static const bool there = __builtin_cpu_supports("avx2") != 0;
  if (!there) return nullptr;
  switch (format) {
    case PixelFormat::kYuyv:
      return classifyPairs<classesOfYuyv, PixelFormat::kYuyv>;
    case PixelFormat::kUyvy:
      return classifyPairs<classesOfUyvy, PixelFormat::kUyvy>;
    case PixelFormat::kNv12:
      return classifyNv12;
    case PixelFormat::kRgb8:
      return classifyTriples<0, 2, PixelFormat::kRgb8>;
    case PixelFormat::kBgr8:
      return classifyTriples<2, 0, PixelFormat::kBgr8>;
    case PixelFormat::kMono8:
      break;
  }
  return nullptr;
}

}  // namespace colortool

#else

namespace colortool {

ClassifyRow avx2ClassifyRow(robotlink::PixelFormat) {
  return nullptr;
}

}  // namespace colortool

#endif
