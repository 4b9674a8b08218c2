// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/driving/Outline.h"

namespace modules {

/// Keeps requests within the limits of the robot: its speeds and accelerations. Not thread-safe.
class SpeedLimiter {
 public:
  /// The request closest to `wanted` that can follow the previous one after `elapsed` seconds. Deceleration
  /// may be twice the acceleration.
  DriveVelocity limit(const DriveVelocity& wanted, const DriveLimits& limits, double elapsed);
  const DriveVelocity& last() const { return last_; }

 private:
  DriveVelocity last_;
};

}  // namespace modules
