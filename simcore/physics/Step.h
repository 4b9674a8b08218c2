// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace simcore {

/// The duration of a step of the physics, s; the same as Simulation::kStep.
inline constexpr double kStepSeconds = 0.004;
/// In each step, a position servo without gains asks for the speed at which it would turn by this share of
/// the angle that is missing; with 1 it would overshoot.
inline constexpr double kStiffServoShare = 0.4;

}  // namespace simcore
