// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"
#include "robotlink/session/StreamMessage.h"

namespace robotcontrol {
class PortReadings;
class ReadPorts;
class SetActuator;
}  // namespace robotcontrol

namespace app {

class ExternalControllers;
class SimulatedWorld;

/// The ports of a simulated world that users read or hold: fulfills ReadPorts and
/// SetActuator, and fills the streams `ports` and those of cameras. Outputs of controllers are read
/// like sensors, and so is the truth about models and sensors; for an actuator, the outcome of its
/// last command. Used by one thread, that of the world, which must outlive it.
class WorldPorts {
 public:
  /// `external` are the remote controllers, and must outlive it; null: there are none. `before` is what
  /// was read of another world; what is missing here is read again as soon as it is there again.
  explicit WorldPorts(SimulatedWorld& world, const ExternalControllers* external = nullptr,
                      const WorldPorts* before = nullptr);

  /// Fails, changing nothing, if a port is unknown.
  robotlink::Result<void> read(const robotcontrol::ReadPorts& request);
  /// `robot` is the one of the request: only its ports are set and released. `stopped` are the robots that
  /// must not move; what they have cannot be held. Fails for those, and for what HeldActuators refuses.
  robotlink::Result<void> set(const std::string& robot, const robotcontrol::SetActuator& request,
                              const std::vector<std::string>& stopped);
  /// Releases what robots that must not move have.
  void release(const std::vector<std::string>& stopped);

  /// Whether there is something to show.
  bool isEmpty() const;
  bool holdsAny() const;
  /// The readings of this instant.
  std::shared_ptr<const robotcontrol::PortReadings> readings() const;
  /// The images of cameras that are read and that no robot sends, on the paths of their ports: of those that
  /// are due now, or of all; and those of sensors of depth, classes and radiation, and of controllers.
  std::vector<robotlink::StreamMessage> images(bool all);

 private:
  /// The paths of what can be read.
  std::vector<std::string> readable() const;
  void addOutputs(robotcontrol::PortReadings& to) const;
  /// Adds what the oracle knows of models and sensors.
  void addTruth(robotcontrol::PortReadings& to) const;

  SimulatedWorld& world_;
  const ExternalControllers* external_;
  std::set<std::string> read_;
};

}  // namespace app
