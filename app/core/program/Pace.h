// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

#include "robotlink/base/Clock.h"

namespace app {

/// Says when in real time an instant of a platform is due, at a speed. A plain value: the real time is passed
/// in.
///
/// Who falls behind by more than kMaxLag does not catch up: after a breakpoint has stopped the world, or a
/// program was too slow for its speed, it goes on from where it is, without a jump.
class Pace {
 public:
  using RealTime = std::chrono::steady_clock::time_point;
  static constexpr std::chrono::milliseconds kMaxLag{200};

  /// Times real time; 0 is as fast as possible. Takes effect with the next restart().
  void setSpeed(double speed) { speed_ = speed; }
  double speed() const { return speed_; }

  /// It is `time` on the platform now.
  void restart(RealTime now, robotlink::Instant time);
  RealTime due(robotlink::Instant time) const;
  /// Before a step to `time` is made: restarts if that is much too late.
  void forgetLag(RealTime now, robotlink::Instant time);
  /// Which instant of the platform is due at `now`.
  robotlink::Instant timeAt(RealTime now) const;

 private:
  double speed_ = 1;
  RealTime start_;
  robotlink::Instant startTime_;
};

}  // namespace app
