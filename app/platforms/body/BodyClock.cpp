// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/body/BodyClock.h"

#include <algorithm>

namespace app {
namespace {

using robotlink::Duration;
using robotlink::Instant;

/// A step back by more than this means that the body's clock was restarted, not that messages are out of
/// order.
constexpr Duration kNewBeginning = std::chrono::seconds(1);
/// Times and shifts beyond it are nonsense; no sum of some of them leaves what an Instant can hold.
constexpr Duration kMaxTime = std::chrono::hours(24 * 365 * 70);
/// The time over which the shortest delay is determined.
constexpr Duration kLookTime = std::chrono::seconds(1);

}  // namespace

Instant BodyClock::now() const {
  const std::int64_t time = local_.now().time_since_epoch().count() + offset_.load();
  std::int64_t newest = newest_.load();
  while (newest < time && !newest_.compare_exchange_weak(newest, time)) {
  }
  return Instant(Duration(std::max(newest, time)));
}

void BodyClock::hear(Instant bodyTime) {
  const Instant local = local_.now();
  bodyTime = std::clamp(bodyTime, Instant(), Instant(kMaxTime));
  if (heard_ && bodyTime < *heard_ - kNewBeginning) shift_ = std::min(now() - bodyTime, kMaxTime);
  const Instant mapped = bodyTime + shift_;
  const Duration ahead = local + Duration(offset_.load()) - mapped;
  if (!heard_ || ahead < Duration::zero()) {
    offset_ -= ahead.count();
    ahead_ = Duration::zero();
  } else {
    ahead_ = std::min(ahead_, ahead);
  }
  heard_ = bodyTime;
  if (local - lookedAt_ < kLookTime) return;
  // A body that is slower than real time, or a line whose delay has grown.
  if (ahead_ != Duration::max()) offset_ -= ahead_.count();
  ahead_ = Duration::max();
  lookedAt_ = local;
}

}  // namespace app
