// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "modules/motion/LegKinematics.h"

namespace modules {

/// How a body stands over the ground. A plain value.
struct BodyTilt {
  double height = 0;  ///< m, of the body's origin
  double pitch = 0;   ///< rad, nose down is positive
  double roll = 0;    ///< rad, left side up is positive

  /// The robot's frame is on the ground below the body's origin and has its heading.
  robotlink::Pose3 bodyInRobot() const;
  bool operator==(const BodyTilt&) const = default;
};

/// Angles of the head, rad: tilt up, pan to the left and roll to the right (left side up) are positive.
struct NeckAngles {
  double tilt = 0, pan = 0, roll = 0;
};

/// The lens: x along the optical axis, y to the left, z up.
robotlink::Pose3 cameraInBody(const RobotDimensions& dimensions, const NeckAngles& neck);

/// Estimates how the body stands from where its paws are: the ground is the plane that fits them best. Paws
/// that touch it count more than those that do not; what they leave open (a trot has two) is drawn to the
/// body's usual slope.
class BodyPosture {
 public:
  struct Options {
    double groundWeight = 20;  ///< of a paw that touches against one that does not
    double levelWeight = 1;    ///< of the usual slope, against one paw in the air
    double usualPitch = robotlink::radians(4.8);
  };
  BodyPosture(const LegKinematics& legs, const Options& options) : legs_(legs), options_(options) {}

  /// Both by leg, in the order of kLegs.
  BodyTilt estimate(const std::array<LegAngles, 4>& angles, const std::array<bool, 4>& contacts) const;

 private:
  LegKinematics legs_;
  Options options_;
};

}  // namespace modules
