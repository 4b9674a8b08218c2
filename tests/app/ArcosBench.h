// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/core/ArcosSimulation.h"
#include "robotlink/arcos/codec/Command.h"
#include "robotlink/arcos/codec/ServerPackets.h"
#include "robotlink/arcos/stream/ByteStream.h"

namespace app {

/// A client of a robot's TCP port, as bare as those of the recordings: it sends packets and keeps what comes.
class WireClient {
 public:
  /// Connects; closed() if that failed.
  explicit WireClient(const std::string& url);

  void send(std::span<const std::uint8_t> bytes);
  void send(const robotlink::arcos::Packet& packet) { send(encode(packet)); }
  void send(robotlink::arcos::CommandId id) { send(toPacket(robotlink::arcos::command(id))); }
  void send(robotlink::arcos::CommandId id, int argument) {
    send(toPacket(robotlink::arcos::command(id, argument)));
  }
  void send(robotlink::arcos::CommandId id, const std::string& argument) {
    send(toPacket(robotlink::arcos::command(id, argument)));
  }
  void handshake();
  /// Takes what came.
  void receive(robotlink::Instant now);
  void close() {
    stream_.reset();
    closed_ = true;
  }
  /// The far end has closed it.
  bool closed() const { return closed_; }

  std::vector<robotlink::arcos::Packet> received;
  std::vector<robotlink::Instant> receivedAt;
  std::uint64_t sentBytes = 0;
  std::uint64_t readPackets() const { return parser_.counters().packets; }

  std::vector<robotlink::arcos::Packet> of(std::uint8_t id) const;
  std::vector<robotlink::arcos::StandardInformation> information() const;
  robotlink::arcos::StandardInformation latest() const;
  void forget();

 private:
  std::unique_ptr<robotlink::arcos::ByteStream> stream_;
  robotlink::arcos::PacketParser parser_;
  bool closed_ = false;
};

/// A simulation of Pioneers with real TCP ports, stepped by the test as fast as possible: what clients send
/// is there before the next step, and what robots say is read after it, so that nothing depends on how fast
/// the machine is.
class ArcosBench {
 public:
  /// `contents`: SDF of models besides the floor and p3at1 at the origin.
  explicit ArcosBench(const std::string& contents = {}, SimulatedWorld::Options world = quiet());
  /// A file instead, with robots as they are put there.
  explicit ArcosBench(const std::filesystem::path& scene, int robots,
                      SimulatedWorld::Options world = quiet());

  /// Without noise, and without the odometry's errors.
  static SimulatedWorld::Options quiet();

  ArcosSimulation& simulation() { return *simulation_; }
  SimulatedWorld& world() { return simulation_->world(); }
  robotlink::Instant now() const { return simulation_->world().clock().now(); }
  /// Of a client that was accepted; it lives as long as the bench.
  WireClient& connect(std::size_t robot = 0);
  /// One more client of which nothing is expected.
  std::unique_ptr<WireClient> knock(std::size_t robot = 0);

  void step();
  void run(double seconds);
  /// With a pulse each half second from every client.
  void drive(double seconds);
  /// Until something is so, at most for some simulated seconds.
  template <typename Condition>
  bool runUntil(Condition condition, double most) {
    for (const auto end = now() + robotlink::fromSeconds(most); now() < end && !condition();) step();
    return condition();
  }
  /// Moves bytes without a step.
  void settle();
  /// What people were told.
  std::vector<std::string> told;

 private:
  struct Connection {
    std::size_t robot = 0;
    std::unique_ptr<WireClient> client;
    std::uint64_t sentBefore = 0;  ///< by the server, at this port
  };
  void create(std::shared_ptr<const simcore::Scene> scene, const SimulatedWorld::Options& world);

  std::unique_ptr<ArcosSimulation> simulation_;
  std::vector<Connection> connections_;
};

}  // namespace app
