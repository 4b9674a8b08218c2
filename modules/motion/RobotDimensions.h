// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "robotlink/base/Geometry.h"

namespace modules {

/// The legs, in the order of BodySensors.paw_contacts.
enum class Leg { kFrontLeft, kFrontRight, kHindLeft, kHindRight };
inline constexpr std::array<Leg, 4> kLegs{Leg::kFrontLeft, Leg::kFrontRight, Leg::kHindLeft, Leg::kHindRight};

constexpr bool isFore(Leg leg) {
  return leg == Leg::kFrontLeft || leg == Leg::kFrontRight;
}
constexpr bool isLeft(Leg leg) {
  return leg == Leg::kFrontLeft || leg == Leg::kHindLeft;
}
constexpr std::size_t index(Leg leg) {
  return static_cast<std::size_t>(leg);
}

/// Lengths of the ERS-210, in metres and radians. The body's frame: origin in the middle between the four J1
/// axes, x to the front, y to the left, z up. Source: Sony's Model Information for the ERS-210 (external
/// dimensions, stance drawing); the paws' centres follow from the stance drawing and agree with the kinematic
/// tables of Tekkotsu.
struct RobotDimensions {
  double hipX = 0.0595;  ///< J1 axes before and behind the origin
  double hipY = 0.0592;  ///< shoulders beside the origin
  double pawOffset = 0;  ///< how much further out the paws are than the shoulders (0.5 mm in the drawing; the
                         ///< model has none)
  double kneeDown = 0.0640;    ///< from J1 to J3 with all angles 0
  double kneeAway = 0.0128;    ///< the same, away from the body's middle
  double foreShank = 0.05699;  ///< from J3 to the centre of the paw's sphere
  double hindShank = 0.06457;
  double foreShankAngle =
      robotlink::radians(-11.86);  ///< of that line against the downward direction, with J3 at 0
  double hindShankAngle = robotlink::radians(-20.09);
  double pawRadius = 0.0125;
  double neckX = 0.0750;  ///< tilt axis
  double neckZ = 0.0500;
  double neckLength = 0.0480;  ///< from the tilt axis to the centre of pan and roll
  double cameraX = 0.0666;     ///< lens before the pan axis
};

}  // namespace modules
