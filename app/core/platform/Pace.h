// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

#include "robotlink/base/Clock.h"

namespace app {

/// Computes when, in real time, an instant of a platform is due at a given speed. A plain value without a
/// clock of its own: the real time is passed in.
///
/// A platform that is late by more than kMaxLag does not catch up. After a breakpoint, or while a program is
/// too slow for the speed, it continues from where it is, without a jump.
class Pace {
 public:
  using RealTime = std::chrono::steady_clock::time_point;
  /// The largest lag that is made up for.
  static constexpr std::chrono::milliseconds kMaxLag{200};

  /// The speed in times real time; 0 means as fast as possible. Call restart() afterward, or past instants
  /// are judged by the new speed.
  void setSpeed(double speed) { speed_ = speed; }
  double speed() const { return speed_; }

  /// Makes `time` due at `now`; later instants are measured from there.
  void restart(RealTime now, robotlink::Instant time);
  /// The real time at which an instant is due; in the past if the speed is 0.
  RealTime due(robotlink::Instant time) const;
  /// Call before a step to `time`: restarts there if the step is late by more than kMaxLag.
  void forgetLag(RealTime now, robotlink::Instant time);
  /// The instant of the platform that is due at `now`.
  robotlink::Instant timeAt(RealTime now) const;

 private:
  double speed_ = 1;
  /// startTime_ is due at start_.
  RealTime start_;
  robotlink::Instant startTime_;
};

}  // namespace app
