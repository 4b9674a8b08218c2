// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/replay/Playback.h"

#include <algorithm>

namespace app {

using robotlink::Instant;

void Playback::play(RealTime real, const Place& place) {
  playing_ = true;
  pace_.restart(real, place.now);
}

void Playback::setSpeed(double speed, RealTime real, const Place& place) {
  // Up to now the old speed counts.
  const Instant now = reached(real, place);
  pace_.setSpeed(speed);
  pace_.restart(real, now);
}

std::optional<Playback::Next> Playback::loopBack(const Place& place) const {
  const Instant from = range_ ? range_->from : place.begin;
  const Instant to = range_ ? range_->to : place.end;
  // After a jump to `from` the log is at the last message before it, which is not outside.
  const bool outside = range_ && ((place.next && *place.next <= from) || place.now > to);
  if (!outside && place.next && *place.next <= to) return std::nullopt;
  const RealTime soonest = lastJump_ + kShortestLoop;
  return Next{Next::What::kJump, outside ? soonest : std::max(soonest, pace_.due(to)), from};
}

std::optional<Playback::Next> Playback::next(const Place& place) const {
  if (!playing_) return std::nullopt;
  if (loop_) {
    if (const auto back = loopBack(place)) return back;
  } else if (!place.next) {
    return Next{Next::What::kPause, pace_.due(place.now)};
  }
  return Next{Next::What::kStep, pace_.due(skips(place) ? place.now : *place.next)};
}

void Playback::stepping(RealTime real, const Place& place) {
  if (!place.next) return;
  if (skips(place)) {
    pace_.restart(real, *place.next);
  } else {
    pace_.forgetLag(real, *place.next);
  }
}

void Playback::jumped(RealTime real, const Place& place) {
  lastJump_ = real;
  pace_.restart(real, place.now);
}

Instant Playback::reached(RealTime real, const Place& place) const {
  if (!playing_ || !place.next || skips(place)) return place.now;
  return std::clamp(pace_.timeAt(real), place.now, *place.next);
}

}  // namespace app
