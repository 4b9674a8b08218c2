// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>

namespace robotlink {

/// The unit of all durations in packages, logs and code: nanoseconds, signed.
using Duration = std::chrono::nanoseconds;

/// The clock type of a platform's time: simulated, logged or real. The platform chooses the zero (a
/// simulation starts at 0), so instants of different platforms must not be compared. Current time comes from
/// a Clock; there is no static now().
struct PlatformTime {
  using duration = Duration;
  using rep = duration::rep;
  using period = duration::period;
  using time_point = std::chrono::time_point<PlatformTime>;
  static constexpr bool is_steady = false;  // NOLINT(readability-identifier-naming): std::chrono wants it
};
/// An instant of a platform's time.
using Instant = PlatformTime::time_point;

/// Converts a duration to seconds, with the precision of a double.
inline double seconds(Duration d) {
  return std::chrono::duration<double>(d).count();
}
/// The seconds since the platform's zero.
inline double seconds(Instant t) {
  return seconds(t.time_since_epoch());
}
/// Converts seconds to a duration, truncated to whole nanoseconds; `s` must be finite and within some 292
/// years.
inline Duration fromSeconds(double s) {
  return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(s));
}

/// Gives a platform's current time. Any thread may call now().
class Clock {
 public:
  virtual ~Clock() = default;
  /// Instants of one clock do not decrease, unless the platform was reset.
  virtual Instant now() const = 0;
};

/// A clock that its owner sets: for simulations, logs and tests. It may be set back. Thread-safe.
class ManualClock final : public Clock {
 public:
  Instant now() const override { return Instant(Duration(now_.load(std::memory_order_acquire))); }
  void set(Instant t) { now_.store(t.time_since_epoch().count(), std::memory_order_release); }
  void advance(Duration d) { now_.fetch_add(d.count(), std::memory_order_acq_rel); }

 private:
  std::atomic<Duration::rep> now_{0};
};

/// Real time since this object was constructed. Never goes back. Thread-safe.
class SteadyClock final : public Clock {
 public:
  Instant now() const override {
    return Instant(std::chrono::duration_cast<Duration>(std::chrono::steady_clock::now() - start_));
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace robotlink
