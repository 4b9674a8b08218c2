// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace robotlink {

/// Mixes a counter into 64 random-looking bits (the finalizer of SplitMix64, Steele et al. 2014). Random
/// numbers computed from (seed, stream, index) are the same for any number and order of threads, unlike those
/// of a generator with state.
constexpr std::uint64_t mixBits(std::uint64_t z) {
  z += 0x9E3779B97F4A7C15ULL;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
  return z ^ (z >> 31);
}

/// Random bits that depend only on the three arguments; `stream` separates uses of one seed.
constexpr std::uint64_t hashBits(std::uint64_t seed, std::uint64_t stream, std::uint64_t index) {
  return mixBits(mixBits(mixBits(seed) ^ stream) ^ index);
}

/// A small deterministic generator: the same seed gives the same numbers. bits() and uniform() are the same
/// on every machine; normal() may differ in its last bits between mathematical libraries. Not thread-safe.
/// Streams of one seed are independent, so that each user can have its own. Draw several numbers in braces,
/// as in Vector2{random.normal(), random.normal()}: arguments in parentheses are evaluated in any order.
class Random {
 public:
  explicit Random(std::uint64_t seed, std::uint64_t stream = 0) : seed_(hashBits(seed, stream, 0)) {}

  /// 64 uniformly distributed bits.
  std::uint64_t bits() { return mixBits(seed_ ^ mixBits(++count_)); }
  /// Uniform in [0, 1).
  double uniform() { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }
  /// Uniform in [low, high).
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Normally distributed with mean 0 and standard deviation 1 (Box-Muller). Takes two uniform numbers and
  /// discards the second result, so that the state stays a mere counter.
  double normal() {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return radius * std::cos(2 * std::numbers::pi * uniform());
  }

 private:
  /// Seed and stream, mixed.
  std::uint64_t seed_;
  /// How many numbers were drawn; with the seed, the whole state.
  std::uint64_t count_ = 0;
};

}  // namespace robotlink
