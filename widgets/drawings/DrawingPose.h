// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The choices of a pose at which the drawings relative to a robot are placed. Besides these there are the
// paths, without the robot, of the streams with its pose estimates ("models/pose").
namespace widgets {

/// The true pose where it is known, else the robot's own estimate.
inline constexpr char kUsualPose[] = "";
/// The true pose only; without it the drawings are left out.
inline constexpr char kTruePose[] = "true";

}  // namespace widgets
