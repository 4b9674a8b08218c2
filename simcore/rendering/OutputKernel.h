// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simcore/rendering/Float8.h"
#include "simcore/rendering/KernelTypes.h"

// Converts lit colors to bytes, and adds noise. Included only by the two Kernels*.cpp.
//
// A pixel's color is multiplied by its light, at most 1. For YCbCr this works on luma and on chroma without
// its offset, because both are linear in the color. Noise is added last, to the bytes, and depends only on
// keys and positions.
namespace simcore::rendering {
namespace {

/// Rounds to 0..255; the value must not be negative.
SIMCORE_INLINE Int8 toBytes(Float8 value) {
  return truncated(minimum(value + 0.5F, splat(255)));
}

/// Writes a row as YCbCr 4:2:2.
void writeYuyv(const float* light, const float* const color[3], int width, std::uint8_t* out) {
  for (int x = 0; x < width; x += 8) {
    // Overexposed pixels keep their hue.
    const Float8 share = minimum(load<Float8>(light + x), splat(1));
    const Int8 luma = toBytes(load<Float8>(color[0] + x) * share);
    const auto blue = load<Float8>(color[1] + x) * share, red = load<Float8>(color[2] + x) * share;
    // The means of pairs: lanes 0 to 3 blue, 4 to 7 red.
    const Float8 even = __builtin_shufflevector(blue, red, 0, 2, 4, 6, 8, 10, 12, 14);
    const Float8 odd = __builtin_shufflevector(blue, red, 1, 3, 5, 7, 9, 11, 13, 15);
    const Int8 chroma = toBytes((even + odd) * 0.5F + 128.0F);
    // Bytes of a word: Y0 Cb Y1 Cr.
    const Int4 words = __builtin_shufflevector(luma, luma, 0, 2, 4, 6) |
                       __builtin_shufflevector(chroma, chroma, 0, 1, 2, 3) << 8 |
                       __builtin_shufflevector(luma, luma, 1, 3, 5, 7) << 16 |
                       __builtin_shufflevector(chroma, chroma, 4, 5, 6, 7) << 24;
    // The last group may be partial; the width is even.
    const int pixels = width - x < 8 ? width - x : 8;
    __builtin_memcpy(out + 2 * x, &words, pixels == 8 ? sizeof(words) : static_cast<std::size_t>(2 * pixels));
  }
}

/// Writes a row as R G B.
void writeRgb(const float* light, const float* const color[3], int width, std::uint8_t* out) {
  for (int x = 0; x < width; x += 8) {
    const Float8 share = minimum(load<Float8>(light + x), splat(1));
    const Int8 words = toBytes(load<Float8>(color[0] + x) * share) |
                       toBytes(load<Float8>(color[1] + x) * share) << 8 |
                       toBytes(load<Float8>(color[2] + x) * share) << 16;
    // Three of the four bytes of each word are written.
    std::uint32_t pixels[8];
    store(pixels, words);
    const int count = width - x < 8 ? width - x : 8;
    for (int i = 0; i < count; ++i) __builtin_memcpy(out + 3 * (x + i), &pixels[i], 3);
  }
}

/// 32 well mixed bits of a counter: the finalizer "lowbias32" (Wellons 2018), with a second key mixed in.
SIMCORE_INLINE Int8 hashed(Int8 counter, NoiseKey key) {
  using UInt8 = std::uint32_t __attribute__((vector_size(32)));
  // The constants are part of the function; changing them changes all noise.
  UInt8 h = reinterpret_cast<UInt8>(counter) ^ key.first;
  h ^= h >> 16;
  h *= 0x7FEB352DU;
  h ^= h >> 15;
  h += key.second;
  h *= 0x846CA68BU;
  h ^= h >> 16;
  return reinterpret_cast<Int8>(h);
}

/// The eight bytes at a place with noise: round(scale * s) is added to each, where s is the sum of four
/// uniform bytes minus its mean: nearly Gaussian (Irwin-Hall). Values below 0 or above 255 are left so.
SIMCORE_INLINE Int8 withNoise(const std::uint8_t* bytes, Int8 counter, NoiseKey key, float scale) {
  // Four uniform bytes, minus their mean of 4 * 127.5.
  const Int8 sum = sumOfBytes(hashed(counter, key)) - 510;
  // For results of 0 or more, adding 0.5 and truncating rounds.
  return truncated(__builtin_convertvector(loadBytes(bytes), Float8) +
                   __builtin_convertvector(sum, Float8) * scale + 0.5F);
}

/// Adds noise to each byte.
void addNoise(std::uint8_t* bytes, int count, NoiseKey key, float scale) {
  constexpr int kBytes = 32;
  const auto add = [&](const std::uint8_t* from, int at, std::uint8_t* to) {
    const Int8 counter = splatInt(at) + Int8{0, 1, 2, 3, 4, 5, 6, 7};
    storeClamped(to, withNoise(from, counter, key, scale), withNoise(from + 8, counter + 8, key, scale),
                 withNoise(from + 16, counter + 16, key, scale),
                 withNoise(from + 24, counter + 24, key, scale));
  };
  const int whole = count / kBytes * kBytes;
  for (int at = 0; at < whole; at += kBytes) add(bytes + at, at, bytes + at);
  if (whole == count) return;
  // The last bytes.
  std::uint8_t last[kBytes] = {};
  const auto size = static_cast<std::size_t>(count - whole);
  __builtin_memcpy(last, bytes + whole, size);
  add(last, whole, last);
  __builtin_memcpy(bytes + whole, last, size);
}

}  // namespace
}  // namespace simcore::rendering
