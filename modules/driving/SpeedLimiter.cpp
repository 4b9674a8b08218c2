// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/driving/SpeedLimiter.h"

namespace modules {

namespace {

double towards(double last, double wanted, double step) {
  // Braking means toward 0.
  const bool braking = last * wanted < 0 || std::abs(wanted) < std::abs(last);
  const double most = braking ? 2 * step : step;
  return last + std::clamp(wanted - last, -most, most);
}

}  // namespace

DriveVelocity SpeedLimiter::limit(const DriveVelocity& wanted, const DriveLimits& limits, double elapsed) {
  // After a pause the robot's velocity is unknown, so at most one cycle counts.
  const double time = std::clamp(elapsed, 0.0, 0.2);
  const double forward = std::isfinite(wanted.forward) ? wanted.forward : 0;
  const double rotation = std::isfinite(wanted.rotation) ? wanted.rotation : 0;
  last_.forward =
      towards(last_.forward, std::clamp(forward, -limits.speed, limits.speed), limits.acceleration * time);
  last_.rotation = towards(last_.rotation, std::clamp(rotation, -limits.rotation, limits.rotation),
                           limits.rotationAcceleration * time);
  return last_;
}

}  // namespace modules
