// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/platforms/simulated/ArcosSimulation.h"
#include "robotlink/arcos/codec/PacketParser.h"
#include "robotlink/arcos/stream/ByteStream.h"
#include "tests/robotlink/arcos/PacketClient.h"

namespace app {

/// A minimal client of a robot's TCP port, like those of the recordings.
class WireClient : public robotlink::arcos::PacketClient {
 public:
  /// Connects; closed() is true if that fails.
  explicit WireClient(const std::string& url);

  using PacketClient::send;
  void send(std::span<const std::uint8_t> bytes);
  void send(const robotlink::arcos::Packet& packet) override { send(encode(packet)); }
  /// Reads everything that has arrived, with `now` as its time.
  void receive(robotlink::Instant now);
  void close() {
    stream_.reset();
    closed_ = true;
  }
  /// Whether the robot has closed the connection.
  bool closed() const { return closed_; }

  std::uint64_t sentBytes = 0;
  /// Number of packets received, including those before forget().
  std::uint64_t readPackets() const { return parser_.counters().packets; }
  /// The last standard information packet.
  robotlink::arcos::StandardInformation latest() const;

 private:
  std::unique_ptr<robotlink::arcos::ByteStream> stream_;
  robotlink::arcos::PacketParser parser_;
  bool closed_ = false;
};

/// A simulation of Pioneers with real TCP ports that the test steps as fast as possible. Everything that
/// clients send arrives before the next step, and everything that robots send is read after it, so that
/// results do not depend on the speed of the machine.
class ArcosBench {
 public:
  /// `contents`: SDF of models in addition to the floor and the robot p3at1 at the origin.
  explicit ArcosBench(const std::string& contents = {}, SimulatedWorld::Options world = quiet());
  /// Loads a file instead and adds `robots` robots.
  explicit ArcosBench(const std::filesystem::path& scene, int robots,
                      SimulatedWorld::Options world = quiet());

  /// Options without noise and odometry errors.
  static SimulatedWorld::Options quiet();

  ArcosSimulation& simulation() { return *simulation_; }
  SimulatedWorld& world() { return simulation_->world(); }
  robotlink::Instant now() const { return simulation_->world().clock().now(); }
  /// A new client that is accepted by a robot; it lives as long as the bench.
  WireClient& connect(std::size_t robot = 0);
  /// Another client, which need not be accepted.
  std::unique_ptr<WireClient> knock(std::size_t robot = 0);

  void step();
  void run(double seconds);
  /// Runs while every client sends a pulse each half second.
  void drive(double seconds);
  /// Runs until a condition holds, for at most `most` simulated seconds. Returns whether it holds.
  template <typename Condition>
  bool runUntil(Condition condition, double most) {
    for (const auto end = now() + robotlink::fromSeconds(most); now() < end && !condition();) step();
    return condition();
  }
  /// Transfers bytes without a simulation step.
  void settle();
  /// The texts that the simulation reported to the user.
  std::vector<std::string> reported;

 private:
  struct Connection {
    std::size_t robot = 0;
    std::unique_ptr<WireClient> client;
    /// Bytes that the server had sent at this port before the connection.
    std::uint64_t sentBefore = 0;
  };
  void create(std::shared_ptr<const simcore::Scene> scene, const SimulatedWorld::Options& world);

  std::unique_ptr<ArcosSimulation> simulation_;
  std::vector<Connection> connections_;
};

}  // namespace app
