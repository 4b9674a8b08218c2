// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "robotlink/base/Geometry.h"

namespace robotlink {

/// The legs, in the order of BodySensors.paw_contacts.
enum class Leg { kFrontLeft, kFrontRight, kHindLeft, kHindRight };
inline constexpr std::array<Leg, 4> kLegs{Leg::kFrontLeft, Leg::kFrontRight, Leg::kHindLeft, Leg::kHindRight};

constexpr bool isFore(Leg leg) {
  return leg == Leg::kFrontLeft || leg == Leg::kFrontRight;
}
constexpr bool isLeft(Leg leg) {
  return leg == Leg::kFrontLeft || leg == Leg::kHindLeft;
}
/// The index of a leg in arrays.
constexpr std::size_t index(Leg leg) {
  return static_cast<std::size_t>(leg);
}

/// Dimensions of the ERS-210 in meters and radians. The body's frame has its origin at the center of the four
/// J1 axes, x to the front, y to the left, z up. Source: Sony's Model Information for the ERS-210 (external
/// dimensions, stance drawing); the paws' centers follow from the stance drawing and agree with the kinematic
/// tables of Tekkotsu.
struct RobotDimensions {
  /// Distance of the J1 axes in front of and behind the origin.
  double hipX = 0.0595;
  /// Distance of the shoulders beside the origin.
  double hipY = 0.0592;
  /// How much farther out the paws are than the shoulders (0.5 mm in the drawing, 0 in the model).
  double pawOffset = 0;
  /// The distance from J1 downwards to J3 with all angles at 0.
  double kneeDown = 0.0640;
  /// The same, away from the body's center.
  double kneeAway = 0.0128;
  /// The distance from J3 to the center of the paw's sphere.
  double foreShank = 0.05699;
  double hindShank = 0.06457;
  /// The angle of that line to the downward direction with J3 at 0.
  double foreShankAngle = radians(-11.86);
  double hindShankAngle = radians(-20.09);
  double pawRadius = 0.0125;
  /// The tilt axis.
  double neckX = 0.0750;
  double neckZ = 0.0500;
  /// The distance from the tilt axis to the intersection of pan and roll.
  double neckLength = 0.0480;
  /// The distance from the pan axis to the lens.
  double cameraX = 0.0666;
};

}  // namespace robotlink
