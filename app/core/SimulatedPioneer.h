// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// CONTRACT DRAFT BY THE COORDINATOR (remove this line): SimulatedWorld (app/core/SimulatedWorld.h) will own one SimulatedPioneer for each
// robot with a drive and step them in advance(); please add that there: `std::span<const std::unique_ptr<SimulatedPioneer>> pioneers()`,
// `SimulatedPioneer* pioneer(const std::string& robot)`, so that SimulatedRun's hosted programs and your ArcosPorts use the same ones. CameraRenderer
// should be made only if there are cameras. A world with kinematic robots: SimulatedWorld::Options::kinematic. ArcosPorts takes the pioneers of a
// world; a hosted program's platform is the other possible client of the same pioneer (in-process, packets as values), and only listens while
// somebody is connected by TCP.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "robotlink/arcos/ServerSession.h"

namespace simcore {
class Simulation;
}

namespace app {

/// A Pioneer of a simulation with its microcontroller. One client at a time: a TCP port (ArcosPorts) before the program that runs here.
class SimulatedPioneer {
 public:
  /// Fails if the simulated robot has no drive.
  static robotlink::Result<std::unique_ptr<SimulatedPioneer>> create(simcore::Simulation& simulation, std::string robot,
                                                                     robotlink::arcos::ServerSettings settings);
  const std::string& robot() const;

  /// After each step of the world; tells the wheels what to do in the next one.
  void step(robotlink::Instant now);
  /// The world was reset.
  void reset();

  /// From and to whoever is its client now.
  void take(const robotlink::arcos::Packet& packet, robotlink::Instant now);
  std::vector<robotlink::arcos::Packet> takeOutgoing();
  /// The present client is gone; the robot stops and waits for the next one.
  void clientGone(robotlink::Instant now);

  /// STOP: its stop button is held; the motors are off, whatever any client says.
  void setStopButton(bool held);

  /// While a client is connected from outside (its address, else empty), the program that runs here only listens.
  void setOutsideClient(const std::string& address);
  const std::string& outsideClient() const;
  /// Is told of every packet that goes between the robot and the client from outside.
  using Listener = std::function<void(const robotlink::arcos::Packet& packet, bool fromRobot, robotlink::Instant now)>;
  void setListener(Listener listener);

  const robotlink::arcos::ServerSession& session() const;
};

}  // namespace app
