// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/motions/RobotDimensions.h"

namespace robotlink {

/// Angles of a leg, rad: J1 swings it away from the body's center (fore legs to the front, hind legs to the
/// rear), J2 spreads it outwards, J3 bends the knee such that the paw moves away from the center.
struct LegAngles {
  double swing = 0, spread = 0, knee = 0;
  bool operator==(const LegAngles&) const = default;
};

/// Forward and inverse kinematics of the ERS-210's legs, in closed form.
///
/// Points are the center of the paw's sphere in meters relative to the shoulder or hip (the intersection of
/// the axes of J1 and J2), with axes parallel to the body's. The inverse yields the posture with the knee
/// bent toward the body's center, as in walking, within the software limits of the joints; the limit of J2
/// depends on J1 (Sony's Model Information).
class LegKinematics {
 public:
  /// The result of the inverse kinematics.
  struct Solution {
    LegAngles angles;
    /// False if the paw cannot reach the point and only comes close to it.
    bool reached = true;
  };

  explicit LegKinematics(const RobotDimensions& dimensions = {}) : dimensions_(dimensions) {}

  const RobotDimensions& dimensions() const { return dimensions_; }
  /// The position of a shoulder or hip in the body's frame.
  Vector3 hipInBody(Leg leg) const;
  /// Forward kinematics.
  Vector3 pawInHip(Leg leg, const LegAngles& angles) const;
  /// Inverse kinematics.
  Solution anglesFor(Leg leg, const Vector3& pawInHip) const;

  /// The lower limit of J2 for an angle of J1.
  static double minimumSpread(Leg leg, double swing);
  /// The nearest angles within the limits.
  static LegAngles limited(Leg leg, const LegAngles& angles);

 private:
  /// The length of the lower leg, and its angle with the knee at 0.
  double shank(Leg leg) const { return isFore(leg) ? dimensions_.foreShank : dimensions_.hindShank; }
  double shankAngle(Leg leg) const {
    return isFore(leg) ? dimensions_.foreShankAngle : dimensions_.hindShankAngle;
  }

  RobotDimensions dimensions_;
};

}  // namespace robotlink
