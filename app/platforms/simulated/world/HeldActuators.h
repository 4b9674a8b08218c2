// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"

namespace simcore {
class Simulation;
}

namespace app {

/// The actuators of a simulation that a person holds at values of their own, whatever robots' programs ask of
/// them, by the paths of their ports: servos and motors (rad, rad/s or N m), drives (speeds of the left and
/// the right rims, m/s), models that are guided (the values of their port) and doors (from 0.5 on open). A
/// held servo has all of its torque. A drive whose motors are off does not turn its wheels.
class HeldActuators {
 public:
  /// Holds an actuator at these values, which are clamped to its range. Fails, changing nothing, if there is
  /// no such actuator, if it takes another number of values, or if one is not finite.
  robotlink::Result<void> hold(const simcore::Simulation& simulation, const std::string& port,
                               const std::vector<double>& values);
  /// Releases one actuator; does nothing if it is not held. Wheels and guided models stop, motors exert
  /// nothing, servos hold their angle until a program asks for another one, doors close in their time.
  void release(simcore::Simulation& simulation, const std::string& port);
  /// Releases all actuators of a model, or with an empty name all that there are.
  void releaseModel(simcore::Simulation& simulation, const std::string& model);
  /// Forgets all of them, since the simulation starts over.
  void forget() { held_.clear(); }
  /// Forgets those that no longer exist.
  void forgetMissing(const simcore::Simulation& simulation);

  /// Sets the actuators again; call this before each step of the simulation.
  void apply(simcore::Simulation& simulation) const;

  /// The values of a held actuator.
  struct Held {
    /// The model that it is part of.
    std::string model;
    std::vector<double> values;
  };
  /// All that are held, by port.
  const std::map<std::string, Held>& all() const { return held_; }

 private:
  std::map<std::string, Held> held_;
};

}  // namespace app
