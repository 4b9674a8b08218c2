// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/compare/Bootstrap.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

#include "robotlink/base/Random.h"

namespace app {
namespace {

constexpr int kResamples = 2000;
constexpr double kOutside = 0.025;  // below the lower bound, and as many above the upper one
constexpr std::uint64_t kSeed = 1979;
/// For at most this many values, all permutations are tried.
constexpr std::size_t kMaxExact = 12;
constexpr int kPermutations = 4000;

}  // namespace

MeanInterval bootstrapMean(const std::vector<double>& values) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (values.empty()) return {0, -kInfinity, kInfinity};
  const auto count = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  if (values.size() < 2) return {mean, -kInfinity, kInfinity};
  std::vector<double> means(kResamples);
  robotlink::Random random(kSeed, 0);
  for (double& resampled : means) {
    double sum = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
      sum += values[std::min(static_cast<std::size_t>(random.uniform() * count), values.size() - 1)];
    resampled = sum / count;
  }
  std::ranges::sort(means);
  const auto at = [&](double share) { return means[static_cast<std::size_t>(share * (kResamples - 1))]; };
  return {mean, at(kOutside), at(1 - kOutside)};
}

double chanceOf(const std::vector<double>& values) {
  if (values.empty()) return 1;
  const double found = std::abs(std::accumulate(values.begin(), values.end(), 0.0));
  // Sums that differ by rounding are equal.
  const double enough = found * (1 - 1e-12);
  const auto isAsFar = [&](const auto& isFlipped) {
    double sum = 0;
    for (std::size_t i = 0; i < values.size(); ++i) sum += isFlipped(i) ? -values[i] : values[i];
    return std::abs(sum) >= enough;
  };
  int asFar = 0;
  if (values.size() <= kMaxExact) {
    const std::uint32_t all = 1U << values.size();
    for (std::uint32_t flips = 0; flips < all; ++flips)
      asFar += isAsFar([&](std::size_t i) { return ((flips >> i) & 1U) != 0; }) ? 1 : 0;
    return static_cast<double>(asFar) / all;
  }
  robotlink::Random random(kSeed, 1);
  for (int i = 0; i < kPermutations; ++i)
    asFar += isAsFar([&](std::size_t) { return random.uniform() < 0.5; }) ? 1 : 0;
  // The values as they are count as one of the permutations.
  return static_cast<double>(asFar + 1) / (kPermutations + 1);
}

std::vector<double> corrected(const std::vector<double>& chances) {
  std::vector<std::size_t> order(chances.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return chances[i]; });
  std::vector<double> result(chances.size());
  double least = 1;
  for (std::size_t rank = order.size(); rank > 0; --rank) {
    const std::size_t i = order[rank - 1];
    least = std::min(least, chances[i] * static_cast<double>(order.size()) / static_cast<double>(rank));
    result[i] = least;
  }
  return result;
}

}  // namespace app
