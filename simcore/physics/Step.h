// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace simcore {

/// One step of the physics, s; the same as Simulation::kStep.
inline constexpr double kStepSeconds = 0.004;

}  // namespace simcore
