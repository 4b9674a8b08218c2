// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/session/TimeShift.h"

#include <algorithm>

namespace robotlink::websocket {
namespace {

/// No sum of two times leaves what an Instant can hold.
constexpr Instant kMaxTime{std::chrono::hours(24 * 365 * 100)};

}  // namespace

void TimeShift::reset() {
  newestRemote_.reset();
}

Instant TimeShift::map(Instant remote, std::optional<Instant> leading) {
  remote = std::clamp(remote, Instant(), kMaxTime);
  if (gap_ && newest_ && !leading) offset_ = *newest_ + *gap_ - remote;
  const bool isNewest = gap_ || !newestRemote_ || remote > *newestRemote_;
  gap_.reset();
  if (!isNewest) return std::max(remote + offset_, Instant());
  newestRemote_ = remote;
  if (leading) {
    const Instant lead = std::clamp(*leading, Instant(), kMaxTime);
    const Duration ahead = remote + offset_ - lead;
    if (!newest_ || ahead > kMaxDistance || ahead < -kMaxDistance) offset_ = lead - remote;
    // Never back, whatever the leading time does.
    if (newest_ && remote + offset_ < *newest_) offset_ = *newest_ - remote;
  }
  newest_ = remote + offset_;
  return *newest_;
}

}  // namespace robotlink::websocket
