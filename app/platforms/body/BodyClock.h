// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <optional>

#include "robotlink/base/Clock.h"

namespace app {

/// The clock by which the local program of a remote body runs. It follows the times received from the
/// body, whatever their delay: it is the body's time less the shortest delay. Between them, and while the
/// link is cut, it continues as real time does. It never goes back: a body that is restarted, whose times
/// begin again, continues.
///
/// now() may be called from any thread, the rest from one.
class BodyClock final : public robotlink::Clock {
 public:
  /// `local` is real time, and must outlive this object.
  explicit BodyClock(const robotlink::Clock& local) : local_(local) {}

  robotlink::Instant now() const override;
  /// Call this when a time of the body has arrived.
  void hear(robotlink::Instant bodyTime);
  /// The newest one; zero before the first.
  robotlink::Instant heard() const { return heard_.value_or(robotlink::Instant()); }
  /// To be added to time stamps of the body: zero until it is restarted.
  robotlink::Duration shift() const { return shift_; }

 private:
  const robotlink::Clock& local_;
  /// The nanoseconds by which local time is behind; and the newest result of now().
  std::atomic<std::int64_t> offset_{0};
  mutable std::atomic<std::int64_t> newest_{0};
  std::optional<robotlink::Instant> heard_;
  robotlink::Duration shift_{0};
  /// The least by which this clock was ahead of the times received since lookedAt_.
  robotlink::Duration ahead_ = robotlink::Duration::max();
  robotlink::Instant lookedAt_;
};

}  // namespace app
