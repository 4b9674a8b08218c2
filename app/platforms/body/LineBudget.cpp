// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/body/LineBudget.h"

#include <algorithm>
#include <utility>

namespace app {
namespace {

/// A queue is emptied quickly, and what the line carries beyond is found slowly.
constexpr double kLess = 0.75, kMore = 1.1;
/// A budget of this many times what is sent limits nothing.
constexpr double kFarAway = 2;

}  // namespace

void LineBudget::measured(robotlink::Duration roundTrip, double bytesPerSecond) {
  shortest_ = std::min(shortest_, roundTrip);
  const auto queue = roundTrip - shortest_;
  // A single long one may be of a computer that was busy.
  const bool wasLong = std::exchange(isLong_, queue > kTooLong);
  if (isLong_ && (wasLong || budget_ > 0)) {
    const double now = budget_ > 0 ? std::min(budget_, bytesPerSecond) : bytesPerSecond;
    budget_ = std::max(kLeast, kLess * now);
  } else if (queue < kShort && budget_ > 0) {
    budget_ *= kMore;
    if (budget_ > kFarAway * bytesPerSecond) budget_ = 0;
  }
}

}  // namespace app
