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

/// TCP ports through which other programs drive the Pioneers of a simulated world as if they were real: the
/// first robot at the first port, the next one at the next. A client that connects takes the robot over from
/// the program that runs here. When it disconnects, the robot stops, and its port is free at once. The
/// simulation never waits for a client.
///
/// Used between the steps of the world by the thread that steps it. The world must outlive it.
class ArcosPorts final : private robotlink::arcos::RobotPorts::Listener {
 public:
  /// The addresses at which the ports are opened.
  struct Options {
    /// An address of this computer; any but a loopback address opens the robots to the network.
    std::string address = "127.0.0.1";
    /// 0 chooses free ports.
    std::uint16_t firstPort = 8101;
  };
  /// Called with a line for the user when a client connects, disconnects, or writes to the simulator's log.
  /// If a client writes too much, only some lines are passed on, then the number of those left out.
  using Log = std::function<void(const std::string& text)>;

  /// Opens the ports. Fails if the world has no Pioneer or if a port cannot be opened.
  static robotlink::Result<std::unique_ptr<ArcosPorts>> open(SimulatedWorld& world, const Options& options,
                                                             Log logger = {});
  /// Disconnects all clients.
  ~ArcosPorts() override;

  /// Receives what clients send until this instant. If it is in the past, only what has already arrived.
  void serve(std::chrono::steady_clock::time_point until);
  /// Sends what the robots send to their clients, and fulfills what clients requested of the simulator.
  void deliver();

  /// The address of a robot by its index: "tcp://127.0.0.1:8101".
  std::string url(std::size_t robot) const;
  const robotlink::arcos::RobotPorts& ports() const { return *ports_; }
  /// A sentence for the user if programs on other computers can drive the robots; otherwise empty.
  std::string warning() const;
  /// The number of lines from this robot's clients that were left out.
  std::uint64_t suppressedTexts(std::size_t robot) const { return texts_.at(robot).suppressed(); }
  /// The exit status with which a client asked the simulation to end; unset if none did.
  std::optional<int> exitRequest() const { return exit_; }

 private:
  ArcosPorts(SimulatedWorld& world, Options options, Log logger);
  // Called by RobotPorts with the index of the robot.
  void clientCame(std::size_t robot, const std::string& address) override;
  void packetCame(std::size_t robot, const robotlink::arcos::Packet& packet) override;
  void clientGone(std::size_t robot) override;
  /// Fulfills what a robot's clients requested of the simulator.
  void fulfilRequests(std::size_t robot);
  /// Passes a text about a robot to the log, unless there are too many.
  void log(std::size_t robot, const std::string& text);
  /// Logs how many texts were left out, once a second.
  void logSuppressed();

  SimulatedWorld& world_;
  const Options options_;
  const Log log_;
  std::unique_ptr<robotlink::arcos::RobotPorts> ports_;
  /// The text limit of each robot.
  std::vector<TextLimit> texts_;
  std::optional<int> exit_;
};

}  // namespace app
