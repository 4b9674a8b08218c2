// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/session/remote/TimeShift.h"

#include <algorithm>

namespace robotlink::websocket {
namespace {

/// All times lie between zero and this one, so that no sum of them leaves what an Instant can hold (292
/// years).
constexpr Instant kMaxTime{std::chrono::hours(24 * 365 * 100)};
constexpr Duration kMaxGap = std::chrono::hours(24 * 365);

}  // namespace

void TimeShift::reset() {
  newestRemote_.reset();
}

Instant TimeShift::map(Instant remote, std::optional<Instant> leading) {
  remote = std::clamp(remote, Instant(), kMaxTime);
  if (gap_ && newest_ && !leading) offset_ = *newest_ + std::clamp(*gap_, Duration(), kMaxGap) - remote;
  const bool isNewest = gap_ || !newestRemote_ || remote > *newestRemote_;
  gap_.reset();
  if (!isNewest) return std::clamp(remote + offset_, Instant(), kMaxTime);
  newestRemote_ = remote;
  if (leading) {
    const Instant lead = std::clamp(*leading, Instant(), kMaxTime);
    const Duration ahead = remote + offset_ - lead;
    if (!newest_ || ahead > kMaxDistance || ahead < -kMaxDistance) offset_ = lead - remote;
    // Never back, whatever the leading time does.
    if (newest_ && remote + offset_ < *newest_) offset_ = *newest_ - remote;
  }
  newest_ = std::clamp(remote + offset_, Instant(), kMaxTime);
  return *newest_;
}

Instant TimeShift::mapLatched(Instant remote, std::optional<Instant> leading) {
  remote = std::clamp(remote, Instant(), kMaxTime);
  // The next message decides how long the gap was.
  if (gap_ && newest_) return *newest_;
  if (newestRemote_ && newest_) return std::clamp(remote + offset_, Instant(), *newest_);
  const Instant mapped = leading ? std::clamp(*leading, Instant(), kMaxTime) : remote;
  newest_ = std::max(newest_.value_or(Instant()), mapped);
  return mapped;
}

}  // namespace robotlink::websocket
