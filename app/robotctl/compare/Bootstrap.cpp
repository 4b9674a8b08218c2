// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/compare/Bootstrap.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>

#include "robotlink/base/Random.h"

namespace app {
namespace {

constexpr int kResamples = 2000;
constexpr double kOutside = 0.025;  // below the lower bound, and as many above the upper one
constexpr std::uint64_t kSeed = 1979;

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

}  // namespace app
