// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/log/MessageDensity.h"

#include <algorithm>

namespace widgets {

using robotlink::Duration;
using robotlink::Instant;

MessageDensity::MessageDensity(std::vector<Instant> times) : count_(times.size()) {
  if (times.size() <= kExact) {
    times_ = std::move(times);
    times_.shrink_to_fit();
    return;
  }
  first_ = times.front();
  last_ = times.back();
  sums_.resize(kBins + 1);
  const double span = std::max(1.0, static_cast<double>((last_ - first_).count()));
  for (const Instant time : times) {
    const double share = static_cast<double>((time - first_).count()) / span;
    ++sums_[std::min(kBins - 1, static_cast<std::size_t>(share * kBins)) + 1];
  }
  for (std::size_t i = 1; i < sums_.size(); ++i) sums_[i] += sums_[i - 1];
}

std::uint64_t MessageDensity::before(Instant time) const {
  if (sums_.empty()) {
    return static_cast<std::uint64_t>(std::lower_bound(times_.begin(), times_.end(), time) - times_.begin());
  }
  if (time <= first_) return 0;
  if (time > last_) return count_;
  const double span = std::max(1.0, static_cast<double>((last_ - first_).count()));
  const double place = static_cast<double>((time - first_).count()) / span * kBins;
  const auto bin = std::min(kBins - 1, static_cast<std::size_t>(place));
  const double within = static_cast<double>(sums_[bin + 1] - sums_[bin]) * (place - static_cast<double>(bin));
  return sums_[bin] + static_cast<std::uint64_t>(within);
}

Instant MessageDensity::snapped(Instant time, Duration reach) const {
  const auto later = std::lower_bound(times_.begin(), times_.end(), time);
  Instant best = time;
  Duration distance = reach;
  if (later != times_.end() && *later - time <= distance) {
    best = *later;
    distance = *later - time;
  }
  if (later != times_.begin() && time - *std::prev(later) <= distance) best = *std::prev(later);
  return best;
}

}  // namespace widgets
