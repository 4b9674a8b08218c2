// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/noise/SampleClock.h"

#include <algorithm>
#include <cmath>

#include "robotlink/base/Random.h"

namespace simcore {
namespace {

/// Separates drop-outs from other uses of a seed.
constexpr std::uint64_t kDropStream = 0x64726F70;
// A sample that is due by less than this fraction of a step is due now, whatever is rounded.
constexpr double kDueEarly = 1e-6;

}  // namespace

SampleClock::SampleClock(const SensorErrors& errors, std::uint64_t stream, double step)
    : stream_(stream),
      period_(errors.rate > 0 ? std::max(1.0, 1 / (errors.rate * step)) : 1),
      delay_(static_cast<std::uint64_t>(std::ceil(std::max(0.0, errors.delay / step - kDueEarly)))),
      dropout_(errors.dropout) {}

std::optional<std::uint64_t> SampleClock::sampleAt(std::uint64_t seed, std::uint64_t step) const {
  const double last = std::floor(static_cast<double>(step) / period_ + kDueEarly);
  const auto due = static_cast<std::uint64_t>(std::ceil(std::max(0.0, last * period_ - kDueEarly)));
  if (due != step) return std::nullopt;
  const auto number = static_cast<std::uint64_t>(last);
  if (dropout_ > 0) {
    robotlink::Random random(seed, robotlink::hashBits(kDropStream, stream_, number));
    if (random.uniform() < dropout_) return std::nullopt;
  }
  return number;
}

std::uint64_t SampleClock::readable(std::uint64_t seed, std::uint64_t step, std::uint64_t oldest) const {
  if (step < oldest + delay_) return oldest;
  for (std::uint64_t at = step - delay_; at > oldest; --at) {
    if (sampleAt(seed, at)) return at;
  }
  return oldest;
}

}  // namespace simcore
