// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>

namespace robotlink {
class ThreadPool;
}

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
  /// Threads that share the work of a simulation, which gives the same bytes for any number of them; null:
  /// the caller's thread does everything.
  std::shared_ptr<robotlink::ThreadPool> pool = nullptr;
};

}  // namespace simcore
