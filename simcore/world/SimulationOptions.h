// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace simcore {

/// The options of a simulation.
struct SimulationOptions {
  /// The seed of all random numbers: noise and the order of the solver's constraints.
  std::uint64_t seed = 1;
  /// Whether sensors have the noise that the scene's file gives them.
  bool noise = true;
  /// Whether models with a drive follow their odometry, and stop in front of obstacles, instead of being
  /// moved by forces.
  bool kinematic = false;
};

}  // namespace simcore
