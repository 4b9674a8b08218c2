// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace modules {

/// The motion of a ball that rolls freely: dv/dt = -(deceleration + damping v), until it rests. A carpet
/// decelerates it about constantly; a ball that is damped by its own softness and by the air rolls much
/// farther while it is slow. A plain value.
struct RollingBall {
  /// m/s^2.
  double deceleration = 0.3;
  /// 1/s.
  double damping = 0;

  /// The speed after a time, m/s and s; neither may be negative.
  double speedAfter(double speed, double seconds) const {
    const double time = std::min(seconds, secondsToRest(speed));
    if (damping < kNoDamping) return std::max(0.0, speed - deceleration * time);
    const double limit = deceleration / damping;
    return std::max(0.0, (speed + limit) * std::exp(-damping * time) - limit);
  }
  /// The distance that it rolls in a time, m.
  double wayAfter(double speed, double seconds) const {
    const double time = std::min(seconds, secondsToRest(speed));
    if (damping < kNoDamping) return time * (speed - 0.5 * deceleration * time);
    const double limit = deceleration / damping;
    return (speed + limit) * -std::expm1(-damping * time) / damping - limit * time;
  }
  /// Infinite for a ball that never stops.
  double secondsToRest(double speed) const {
    if (deceleration <= 0) return std::numeric_limits<double>::infinity();
    if (damping < kNoDamping) return speed / deceleration;
    return std::log1p(speed * damping / deceleration) / damping;
  }

 private:
  /// Below it the formulas with damping lose their digits, 1/s.
  static constexpr double kNoDamping = 1e-6;
};

}  // namespace modules
