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

class SimulatedWorld;

/// The ports of a simulated world that are read or held by whoever watches it: fulfills ReadPorts and
/// SetActuator, and makes what the streams `ports` and those of cameras show. Used by one thread, that of the
/// world, which must outlive it.
class WorldPorts {
 public:
  explicit WorldPorts(SimulatedWorld& world) : world_(world) {}

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
  /// are due now, or of all.
  std::vector<robotlink::StreamMessage> images(bool all);

 private:
  SimulatedWorld& world_;
  std::set<std::string> read_;
};

}  // namespace app
