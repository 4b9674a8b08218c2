// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "simcore/physics/Physics.h"
#include "simcore/physics/Ports.h"

namespace simcore {

/// Turns the state of a world into the readings of its sensors, with noise that depends on seed, sensor and
/// step only: it does not matter how often, or whether, readings are asked for. Accelerometers compare the
/// velocities of two steps, so afterStep() must be called after each.
class Sensing {
 public:
  /// All of them must outlive it.
  Sensing(const Physics& physics, const std::vector<SensorSource>& sources, const Vector3& gravity);

  void afterStep();
  /// A model was put elsewhere by hand and is at rest: its velocity before that means nothing.
  void forgetVelocitiesOf(int model);

  struct Noise {
    bool on = true;
    std::uint64_t seed = 0;
    std::uint64_t step = 0;
  };
  /// Writes all readings; sensors[i] is measured by sources[i].
  void read(const Noise& noise, std::vector<Sensor>& sensors) const;

 private:
  void readExactly(std::size_t index, std::vector<double>& values) const;

  const Physics& physics_;
  const std::vector<SensorSource>& sources_;
  const Vector3 gravity_;
  std::vector<Vector3> velocities_;      // of accelerometers, by sensor
  std::vector<Vector3> specificForces_;  // acceleration less gravity, in the world, by sensor
};

}  // namespace simcore
