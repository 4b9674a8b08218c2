// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/platform/Pace.h"

#include <algorithm>

namespace app {

using RealDuration = Pace::RealTime::duration;

/// Limits the seconds until an instant is due, so that they fit the clock: a gap in a log may be many years.
constexpr double kFarAway = 1e8;

void Pace::restart(RealTime now, robotlink::Instant time) {
  start_ = now;
  startTime_ = time;
}

Pace::RealTime Pace::due(robotlink::Instant time) const {
  if (speed_ <= 0) return start_;  // steps are always late when running as fast as possible
  const double seconds = robotlink::seconds(time - startTime_) / speed_;
  const std::chrono::duration<double> real(std::clamp(seconds, -kFarAway, kFarAway));
  return start_ + std::chrono::duration_cast<RealDuration>(real);
}

void Pace::forgetLag(RealTime now, robotlink::Instant time) {
  if (now - due(time) > kMaxLag) restart(now, time);
}

robotlink::Instant Pace::timeAt(RealTime now) const {
  return startTime_ + robotlink::fromSeconds(std::chrono::duration<double>(now - start_).count() * speed_);
}

}  // namespace app
