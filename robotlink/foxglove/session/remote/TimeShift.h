// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "robotlink/base/Clock.h"

namespace robotlink::websocket {

/// Maps the times of a server's messages to those of a session that others may share, so that no other
/// machine's clock moves the session's time around.
///
/// Without a leading time, times stay as they are. With one, the newest message is placed at the leading time
/// at first, and again whenever the two are apart by more than kMaxDistance. The time of the newest message
/// never goes back, except at a reset of a server that leads. Older messages keep their distance to it.
class TimeShift {
 public:
  static constexpr Duration kMaxDistance = std::chrono::milliseconds(500);

  /// Call this after a restart of the session: earlier messages do not count.
  void restart() { *this = {}; }
  /// Call this when the server's program, and so its clock, was restarted: the next message follows `gap`
  /// after the last one.
  void continueAfter(Duration gap) { gap_ = gap; }
  /// The server's clock was set back, by a reset of its simulation.
  void reset();

  Instant map(Instant remote, std::optional<Instant> leading);
  /// The same for a latched message, whose time may be from before a reset: other messages are not placed by
  /// it, and it is not newer than they are. Before the first of them it is where it was, or at the leading
  /// time.
  Instant mapLatched(Instant remote, std::optional<Instant> leading);
  /// Whether there was another message than latched ones.
  bool hasTime() const { return newestRemote_.has_value(); }
  /// The newest time so far, as mapped.
  std::optional<Instant> newest() const { return newest_; }

 private:
  Duration offset_{0};
  std::optional<Instant> newestRemote_, newest_;
  std::optional<Duration> gap_;
};

}  // namespace robotlink::websocket
