// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simcore/truth/Distribution.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace simcore::truth {

double kolmogorovOfNormal(std::vector<double> samples, double mean, double deviation) {
  if (!std::ranges::all_of(samples, [](double sample) { return std::isfinite(sample); })) return std::nan("");
  std::ranges::sort(samples);
  const auto count = static_cast<double>(samples.size());
  double largest = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double share = std::erfc((mean - samples[i]) / deviation / std::numbers::sqrt2) / 2;
    const auto below = static_cast<double>(i);
    largest = std::max({largest, share - below / count, (below + 1) / count - share});
  }
  return largest * std::sqrt(count);
}

double chiSquare(std::span<const double> counts, std::span<const double> expected) {
  double sum = 0;
  for (std::size_t i = 0; i < counts.size(); ++i)
    sum += (counts[i] - expected[i]) * (counts[i] - expected[i]) / expected[i];
  const double freedom = static_cast<double>(counts.size()) - 1, part = 2 / (9 * freedom);
  return (std::cbrt(sum / freedom) - (1 - part)) / std::sqrt(part);
}

double chiSquareOfUniform(std::span<const double> samples, double low, double high, int bins) {
  std::vector<double> counts(static_cast<std::size_t>(bins));
  for (const double sample : samples) {
    const int bin = static_cast<int>(std::floor((sample - low) / (high - low) * bins));
    ++counts[static_cast<std::size_t>(std::clamp(bin, 0, bins - 1))];
  }
  const std::vector<double> expected(counts.size(), static_cast<double>(samples.size()) / bins);
  return chiSquare(counts, expected);
}

}  // namespace simcore::truth
