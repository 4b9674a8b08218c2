// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "robotlink/base/Error.h"

namespace simcore {
class Simulation;
}

namespace app {

/// The commands of external controllers to actuators of any kind, by the paths of their ports. The programs
/// of robots and the controllers of the scene command before them, a person who holds an actuator after them.
/// One thread at a time.
class PortCommands {
 public:
  /// Replaces a controller's command of one actuator. Fails if there is no such actuator, if it takes another
  /// number of values, or if one is not finite.
  robotlink::Result<void> set(const simcore::Simulation& simulation, const std::string& controller,
                              const std::string& port, std::vector<double> values);
  /// Releases what a controller commands: wheels and guided models stop, servos keep their last command.
  void release(simcore::Simulation& simulation, const std::string& controller);
  void forget() { commands_.clear(); }
  /// The robots that must not move: what they have is not commanded.
  void setStopped(std::vector<std::string> robots) { stopped_ = std::move(robots); }

  /// Commands all actuators, in the order of the controllers' names; call this before each step. A door
  /// gets each command once, since it closes by itself.
  void apply(simcore::Simulation& simulation);

 private:
  struct Command {
    std::vector<double> values;
    bool isOnce = false, isDone = false;
  };
  /// Keyed by controller and port.
  std::map<std::string, std::map<std::string, Command>> commands_;
  std::vector<std::string> stopped_;
};

}  // namespace app
