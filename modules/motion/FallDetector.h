// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Geometry.h"

namespace modules {

/// Tells from the accelerometer whether the robot lies, and on which side.
///
/// At rest the accelerometer shows the direction upwards; what steps and kicks add is smoothed away.
/// Accelerations in m/s^2 in the body's frame (x to the front, y to the left, z up). A pure function of its
/// calls.
class FallDetector {
 public:
  /// What the robot lies on: its face, its rump (the nose in the air), its back or a flank.
  enum class Side { kNone, kFront, kRear, kBack, kLeft, kRight };

  void update(const robotlink::Vector3& acceleration, robotlink::Duration frame);
  void reset() { *this = {}; }

  bool fallen() const { return fallen_; }
  /// The side that is down; kNone as long as the robot stands more or less upright.
  Side side() const;
  /// The smoothed direction upwards, of length 1.
  robotlink::Vector3 up() const { return up_.normalized(); }

 private:
  robotlink::Vector3 up_{0, 0, 1};
  double tiltedFor_ = 0;  // s
  bool fallen_ = false;
};

}  // namespace modules
