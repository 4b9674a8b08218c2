// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace modules {

/// A velocity of the robot over ground: m/s to the front and to the left, rad/s counterclockwise.
struct WalkSpeed {
  double x = 0, y = 0, rotation = 0;
  bool operator==(const WalkSpeed&) const = default;
};

/// The shape of a paw's curve, seen from the side.
enum class FootMode { kRectangle, kHalfEllipse };

/// The parameters of a gait of the wheel model. Lengths are in meters relative to the shoulders and hips, in
/// a level frame: `height` is that of the center of the paw's sphere below J1, `width` its distance from the
/// robot's plane of symmetry, `centerX` its distance in front of J1. Phases are fractions of a cycle; arrays
/// of two are for fore and hind legs.
struct GaitParameters {
  FootMode footMode = FootMode::kRectangle;
  double foreHeight = 0.1014, foreWidth = 0.0705, foreCenterX = 0.0428;
  double hindHeight = 0.1069, hindWidth = 0.0572, hindCenterX = -0.0313;
  /// The height to which the paws are lifted.
  double foreLift = 0.0081, hindLift = 0.0101;
  /// The distance that a lifted paw moves to the front per meter of lift.
  double foreTilt = -0.65, hindTilt = 0.31;

  /// Duration of a cycle in frames of 8 ms.
  int stepFrames = 54;
  /// The part of the cycle on the ground.
  std::array<double, 2> groundPhase{0.5, 0.5};
  /// The part straight up (only rectangle).
  std::array<double, 2> liftPhase{0.1, 0.1};
  /// The part straight down (only rectangle).
  std::array<double, 2> loweringPhase{0.1, 0.1};
  /// Order of the legs: by default a trot, diagonal legs together.
  std::array<double, 4> legPhase{0, 0.5, 0.5, 0};

  /// Paws move by these factors faster than the robot is to move, to compensate for slip and slow servos.
  double factorX = 0.995, factorBackward = 1, factorY = 1.053, factorRotation = 1.003;
  /// Rotation in rad/s per m/s to the front and to the left, against the drift of the robot.
  double counterRotationX = 0, counterRotationY = 1.29;
  /// Paws move slower to the front by this against a drift ahead when the robot turns or walks aside: m/s
  /// per (rad/s)^2 and per (m/s)^2. It counts less the faster the robot walks ahead or backward, and not at
  /// all from `counterForwardUntil` (m/s) on; 0: never.
  double counterForwardRotation = 0, counterForwardSideways = 0, counterForwardUntil = 0.1;
  /// The distance that the hind paws move to the front per m/s of walking backward, so that they continue to
  /// carry their share.
  double hindShiftBackward = 0.19;
  /// The semi-axes of the ellipsoid of allowed speeds.
  double maximumX = 0.18, maximumBackward = 0.16, maximumY = 0.16, maximumRotation = 1.2;
  /// Per second.
  double maximumChangeX = 0.4, maximumChangeY = 0.4, maximumChangeRotation = 3.0;
  /// The largest travel of a paw on the ground.
  double maximumStepX = 0.060, maximumStepY = 0.060;

  /// Amplitude of the body's sway.
  double bodyShiftX = 0, bodyShiftY = 0;
  /// Its phase.
  double bodyShiftOffset = 0;

  bool operator==(const GaitParameters&) const = default;
};

}  // namespace modules
