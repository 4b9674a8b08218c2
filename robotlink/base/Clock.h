// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>

namespace robotlink {

using Duration = std::chrono::nanoseconds;

/// The clock of a platform: simulated, logged or real time. It starts wherever the platform says
/// (a simulation at 0); instants of different platforms must not be compared.
struct PlatformTime {
  using duration = Duration;
  using rep = duration::rep;
  using period = duration::period;
  using time_point = std::chrono::time_point<PlatformTime>;
  static constexpr bool is_steady = false;  // NOLINT(readability-identifier-naming): std::chrono wants it
};
using Instant = PlatformTime::time_point;

inline double seconds(Duration d) {
  return std::chrono::duration<double>(d).count();
}
inline double seconds(Instant t) {
  return seconds(t.time_since_epoch());
}
inline Duration fromSeconds(double s) {
  return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(s));
}

/// Tells what time it is on a platform. Any thread may ask.
class Clock {
 public:
  virtual ~Clock() = default;
  virtual Instant now() const = 0;
};

/// A clock that somebody else turns: simulations, logs and tests. Thread-safe.
class ManualClock final : public Clock {
 public:
  Instant now() const override { return Instant(Duration(now_.load(std::memory_order_acquire))); }
  void set(Instant t) { now_.store(t.time_since_epoch().count(), std::memory_order_release); }
  void advance(Duration d) { now_.fetch_add(d.count(), std::memory_order_acq_rel); }

 private:
  std::atomic<Duration::rep> now_{0};
};

/// Real time since this clock was made. Thread-safe.
class SteadyClock final : public Clock {
 public:
  Instant now() const override {
    return Instant(std::chrono::duration_cast<Duration>(std::chrono::steady_clock::now() - start_));
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace robotlink
