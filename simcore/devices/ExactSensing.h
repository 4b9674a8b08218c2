// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "simcore/devices/Ports.h"
#include "simcore/physics/Physics.h"

namespace simcore {

class StateStream;

/// Computes what perfect sensors would read. Accelerometers, odometry and batteries need every step, so
/// afterStep() must be called after each. One thread at a time.
class ExactSensing {
 public:
  /// All arguments must outlive it.
  ExactSensing(const Physics& physics, const std::vector<SensorSource>& sources,
               const WorldDescription& world);

  /// Updates what is measured over time.
  void afterStep();
  /// A model was put elsewhere by hand and is at rest: its velocity before that means nothing, and its
  /// odometry does not notice.
  void forgetVelocitiesOf(int model);
  /// A model was set in motion by hand: it has had this velocity before, too.
  void adoptVelocitiesOf(int model);
  /// Writes or reads what is measured over time.
  void transfer(StateStream& stream);
  /// Writes a reading; `values` has its size.
  void read(std::size_t index, std::vector<double>& values) const;

 private:
  /// The state of a sensor that is kept from step to step.
  struct Memory {
    /// Accelerometers: velocity in the last step, and acceleration minus gravity, in the world.
    Vector3 velocity = Vector3::Zero(), specificForce = Vector3::Zero();
    /// Odometry: x, y, heading since the start; the travels of a drive's sides, or where the link was.
    robotlink::Pose2 odometry;
    double left = 0, right = 0;
    robotlink::Pose2 before;
    /// Altimeters: the height at the start, m. Batteries: what is left, J.
    double height = 0, energy = 0;
  };
  Pose3 poseOf(const SensorSource& source) const {
    return physics_.linkInWorld(source.body) * source.poseInLink;
  }
  void start(std::size_t index);
  void accelerate(const SensorSource& source, Memory& memory) const;
  void drive(const SensorSource& source, Memory& memory) const;
  void discharge(const SensorSource& source, Memory& memory) const;
  void readJoint(const SensorSource& source, std::vector<double>& values) const;
  void readPlace(const SensorSource& source, const Memory& memory, std::vector<double>& values) const;
  void readMotion(const SensorSource& source, const Memory& memory, std::vector<double>& values) const;
  double contactOf(const SensorSource& source) const;

  const Physics& physics_;
  const std::vector<SensorSource>& sources_;
  const WorldDescription& world_;
  /// Keyed by sensor.
  std::vector<Memory> memories_;
};

}  // namespace simcore
