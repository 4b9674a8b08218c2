// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace modules {

/// A velocity of the robot over ground: m/s to the front and to the left, rad/s counter-clockwise.
struct WalkSpeed {
  double x = 0, y = 0, rotation = 0;
  bool operator==(const WalkSpeed&) const = default;
};

/// The closed curve that a paw runs through, seen from the side.
enum class FootMode { kRectangle, kHalfEllipse };

/// What describes a gait of the wheel model. Lengths in metres relative to the shoulders and hips, in a level
/// frame: `height` is that of the paw sphere's centre below J1, `width` how far it is from the robot's plane
/// of symmetry, `centerX` how far before J1. Phases are shares of one cycle; those of fore and hind legs
/// differ in the second place of an array.
struct GaitParameters {
  FootMode footMode = FootMode::kRectangle;
  double foreHeight = 0.1014, foreWidth = 0.0705, foreCenterX = 0.0428;
  double hindHeight = 0.1069, hindWidth = 0.0572, hindCenterX = -0.0313;
  double foreLift = 0.0081, hindLift = 0.0101;  ///< how high the paws go
  double foreTilt = -0.65,
         hindTilt = 0.31;  ///< how far a lifted paw goes to the front for each metre of lift

  int stepFrames = 54;                             ///< of 8 ms, of one cycle
  std::array<double, 2> groundPhase{0.5, 0.5};     ///< on the ground
  std::array<double, 2> liftPhase{0.1, 0.1};       ///< straight up (rectangle only)
  std::array<double, 2> loweringPhase{0.1, 0.1};   ///< straight down (rectangle only)
  std::array<double, 4> legPhase{0, 0.5, 0.5, 0};  ///< a trot: the diagonal legs together

  /// Paws are moved by this factor faster than the robot shall go: what slipping and slow servos cost.
  double factorX = 0.995, factorBackward = 1, factorY = 1.053, factorRotation = 1.003;
  /// rad/s of turning for each m/s to the front and to the left: against the robot's drift.
  double counterRotationX = 0, counterRotationY = 1.29;
  /// How far the hind paws come to the front for each m/s of walking backward, so that they go on bearing
  /// their share.
  double hindShiftBackward = 0.19;
  double maximumX = 0.18, maximumBackward = 0.16, maximumY = 0.16,
         maximumRotation = 1.2;  ///< the corners of an ellipsoid of speeds
  double maximumChangeX = 0.4, maximumChangeY = 0.4, maximumChangeRotation = 3.0;  ///< a second
  double maximumStepX = 0.060, maximumStepY = 0.060;  ///< length of a paw's way on the ground

  double bodyShiftX = 0, bodyShiftY = 0;  ///< amplitude of the body's swaying
  double bodyShiftOffset = 0;             ///< phase of it

  bool operator==(const GaitParameters&) const = default;
};

}  // namespace modules
