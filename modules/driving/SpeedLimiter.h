// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/driving/Outline.h"

namespace modules {

/// Keeps requests within what the robot can do: its speeds, and how fast they change.
class SpeedLimiter {
 public:
  /// The request nearest to `wanted` that can follow the last one `elapsed` seconds later. Braking may be
  /// twice as hard.
  DriveVelocity limit(const DriveVelocity& wanted, const DriveLimits& limits, double elapsed);
  const DriveVelocity& last() const { return last_; }

 private:
  DriveVelocity last_;
};

}  // namespace modules
