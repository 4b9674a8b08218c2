// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Geometry.h"

namespace modules {

/// Detects from the accelerometer whether the robot has fallen, and on which side it lies.
///
/// At rest the accelerometer shows the upward direction; steps and kicks are removed by smoothing.
/// Accelerations are in m/s^2 in the body's frame (x to the front, y to the left, z up). The result depends
/// only on the calls. Not thread-safe.
class FallDetector {
 public:
  /// The side on which the robot lies: its front, its rear (nose up), its back or a flank.
  enum class Side { kNone, kFront, kRear, kBack, kLeft, kRight };

  /// Call it once a frame; values that are not finite are ignored.
  void update(const robotlink::Vector3& acceleration, robotlink::Duration frame);
  void reset() { *this = {}; }

  /// True once the robot has been tilted by more than 60 degrees for 0.3 s, or by more than 46 degrees for a
  /// second, as when it sits on its hind legs, until it is nearly upright.
  bool fallen() const { return fallen_; }
  /// The side that is down; kNone while the robot is more or less upright.
  Side side() const;
  /// The smoothed upward direction, of length 1.
  robotlink::Vector3 up() const { return up_.normalized(); }

 private:
  /// Smoothed acceleration, in units of gravity.
  robotlink::Vector3 up_{0, 0, 1};
  /// Seconds.
  double tiltedFor_ = 0, sitsFor_ = 0;
  bool fallen_ = false;
};

}  // namespace modules
