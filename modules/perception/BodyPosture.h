// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "modules/motion/Legs.h"

namespace modules {

/// The posture of a body relative to the ground. A plain value.
struct BodyTilt {
  /// Height of the body's origin, m.
  double height = 0;
  /// Positive if the nose is down, rad.
  double pitch = 0;
  /// Positive if the left side is up, rad.
  double roll = 0;

  /// The robot's frame is on the ground below the body's origin and has the same heading.
  robotlink::Pose3 bodyInRobot() const;
  bool operator==(const BodyTilt&) const = default;
};

/// Angles of the head, rad; positive are tilt upward, pan to the left and roll to the right (left side up).
struct NeckAngles {
  double tilt = 0, pan = 0, roll = 0;
};

/// The pose of the lens: x along the optical axis, y to the left, z up.
robotlink::Pose3 cameraInBody(const RobotDimensions& dimensions, const NeckAngles& neck);

/// Estimates the posture of the body from the positions of its paws: the ground is the plane that fits them
/// best. Paws that touch the ground have more weight; what they leave undetermined (in a trot only two touch)
/// is set by the usual slope of the body. Immutable; any thread.
class BodyPosture {
 public:
  struct Options {
    /// The weight of a paw on the ground relative to one in the air.
    double groundWeight = 20;
    /// The weight of the usual slope relative to a paw in the air.
    double levelWeight = 1;
    /// Nose down, rad.
    double usualPitch = robotlink::radians(4.8);
  };
  BodyPosture(const LegKinematics& legs, const Options& options) : legs_(legs), options_(options) {}

  /// Both arguments are in the order of kLegs.
  BodyTilt estimate(const std::array<LegAngles, 4>& angles, const std::array<bool, 4>& contacts) const;

 private:
  LegKinematics legs_;
  Options options_;
};

}  // namespace modules
