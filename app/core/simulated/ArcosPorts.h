// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/core/program/TextLimit.h"
#include "robotlink/arcos/server/RobotPorts.h"

namespace app {

class SimulatedWorld;

/// TCP ports at which programs find the Pioneers of a simulated world and drive them as they would real ones:
/// the first robot at the first port, the next at the next. A client that comes takes the robot over from the
/// program that runs here; when it goes, the robot stands, and its port is free at once. The simulation waits
/// for nobody.
///
/// The world must outlive it; used by the thread that steps the world, between its steps.
class ArcosPorts final : private robotlink::arcos::RobotPorts::Listener {
 public:
  struct Options {
    std::string address =
        "127.0.0.1";                 ///< of this machine; others than loopback open the robots to the network
    std::uint16_t firstPort = 8101;  ///< 0: ports that are free
  };
  /// What clients did that a person may want to know, one line each: who came and went, and what they wrote
  /// to the simulator's log. Of a client that writes without end some lines, and how many were left out.
  using Log = std::function<void(const std::string& text)>;

  /// Fails if the world has no Pioneer, or a port cannot be opened.
  static robotlink::Result<std::unique_ptr<ArcosPorts>> open(SimulatedWorld& world, const Options& options,
                                                             Log teller = {});
  ~ArcosPorts() override;

  /// Takes what clients send until this instant; one that is past: only what is there already.
  void serve(std::chrono::steady_clock::time_point until);
  /// Sends what the robots say, and fulfils what clients asked of the simulator.
  void deliver();

  /// "tcp://127.0.0.1:8101"
  std::string url(std::size_t robot) const;
  const robotlink::arcos::RobotPorts& ports() const { return *ports_; }
  /// A sentence for people if programs on other machines can drive the robots; else empty.
  std::string warning() const;
  /// How many lines of this robot's clients were left out.
  std::uint64_t suppressedTexts(std::size_t robot) const { return texts_.at(robot).suppressed(); }
  /// The status that a client asked the simulation to end with.
  std::optional<int> exitRequest() const { return exit_; }

 private:
  ArcosPorts(SimulatedWorld& world, Options options, Log teller);
  void clientCame(std::size_t robot, const std::string& address) override;
  void packetCame(std::size_t robot, const robotlink::arcos::Packet& packet) override;
  void clientGone(std::size_t robot) override;
  void fulfilRequests(std::size_t robot);
  void log(std::size_t robot, const std::string& text);
  void logSuppressed();

  SimulatedWorld& world_;
  const Options options_;
  const Log log_;
  std::unique_ptr<robotlink::arcos::RobotPorts> ports_;
  std::vector<TextLimit> texts_;  ///< by robot
  std::optional<int> exit_;
};

}  // namespace app
