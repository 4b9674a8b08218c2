// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/motion/RobotDimensions.h"

namespace modules {

/// Angles of a leg, rad: J1 swings it away from the body's middle (fore legs to the front, hind legs to the
/// back), J2 spreads it to the outside, J3 bends the knee so that the paw goes away from the middle.
struct LegAngles {
  double swing = 0, spread = 0, knee = 0;
  bool operator==(const LegAngles&) const = default;
};

/// From angles of a leg of the ERS-210 to the place of its paw and back, in closed form.
///
/// Points are the centre of the paw's sphere, in metres, relative to the shoulder or hip (where the axes of
/// J1 and J2 meet), in axes parallel to the body's. The inverse yields the posture with the knee bent towards
/// the body's middle, as the robot walks, and stays within the software limits of the joints, of which that
/// of J2 depends on J1 (Sony's Model Information).
class LegKinematics {
 public:
  struct Solution {
    LegAngles angles;
    bool reached = true;  ///< false: the paw comes only near the point
  };

  explicit LegKinematics(const RobotDimensions& dimensions = {}) : dimensions_(dimensions) {}

  const RobotDimensions& dimensions() const { return dimensions_; }
  /// Shoulder or hip in the body's frame.
  robotlink::Vector3 hipInBody(Leg leg) const;
  robotlink::Vector3 pawInHip(Leg leg, const LegAngles& angles) const;
  Solution anglesFor(Leg leg, const robotlink::Vector3& pawInHip) const;

  /// The least angle of J2 for an angle of J1.
  static double minimumSpread(Leg leg, double swing);
  static LegAngles limited(Leg leg, const LegAngles& angles);

 private:
  double shank(Leg leg) const { return isFore(leg) ? dimensions_.foreShank : dimensions_.hindShank; }
  double shankAngle(Leg leg) const {
    return isFore(leg) ? dimensions_.foreShankAngle : dimensions_.hindShankAngle;
  }

  RobotDimensions dimensions_;
};

}  // namespace modules
