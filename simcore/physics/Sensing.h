// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "simcore/physics/Physics.h"
#include "simcore/physics/Ports.h"

namespace simcore {

/// Computes the readings of sensors from the state of the world. The noise depends only on seed, sensor and
/// step, so it does not matter how often, or whether, readings are requested. Accelerometers need the
/// velocities of two steps, so afterStep() must be called after every step. One thread at a time.
class Sensing {
 public:
  /// All arguments must outlive it.
  Sensing(const Physics& physics, const std::vector<SensorSource>& sources, const Vector3& gravity);

  /// Updates the velocities of accelerometers.
  void afterStep();
  /// A model was put elsewhere by hand and is at rest: its velocity before that means nothing.
  void forgetVelocitiesOf(int model);

  /// Selects the random numbers of a reading.
  struct Noise {
    bool on = true;
    std::uint64_t seed = 0;
    std::uint64_t step = 0;
  };
  /// Computes all readings; sensors[i] is measured by sources[i].
  void read(const Noise& noise, std::vector<Sensor>& sensors) const;

 private:
  /// A reading without noise and limits.
  void readExactly(std::size_t index, std::vector<double>& values) const;

  const Physics& physics_;
  const std::vector<SensorSource>& sources_;
  const Vector3 gravity_;
  /// Velocity of each accelerometer in the last step, by sensor.
  std::vector<Vector3> velocities_;
  /// Acceleration minus gravity in the world's frame, by sensor.
  std::vector<Vector3> specificForces_;
};

}  // namespace simcore
