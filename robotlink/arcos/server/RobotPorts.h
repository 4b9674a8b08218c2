// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <memory>
#include <span>
#include <string>

#include "robotlink/arcos/codec/PacketParser.h"
#include "robotlink/base/Error.h"

namespace robotlink::arcos {

/// The TCP ports at which clients find simulated robots, one port each, one client at a time.
///
/// A port listens from open() to the end: a client that goes away leaves it free for the next at once. A
/// second client is accepted and closed at once, which unmodified clients report as a connection that was
/// lost, and which does not disturb the first; unless that has been silent for long, as clients are
/// whose machine has gone. What a client does not read waits in a SendQueue, which drops old packets: a slow
/// reader gets fresh ones.
///
/// Whatever a client sends, it costs the other robots little: each call of serve() takes at most
/// kMaximumBytes and kMaximumPackets from each port; the rest waits for the next call, first here, then in
/// the client's system, which stops sending.
///
/// No thread of its own: bytes move in serve() and send(), which one thread calls.
class RobotPorts {
 public:
  /// What one port may take in one call of serve(). Real robots obey about 300 packets a second.
  static constexpr std::size_t kMaximumBytes = 16U << 10U;
  static constexpr std::size_t kMaximumPackets = 64;
  struct Options {
    std::string address =
        "127.0.0.1";                 ///< of this machine; others than loopback open the robots to the network
    std::uint16_t firstPort = 8101;  ///< the next robot has the next one; 0: each has one that is free
    std::size_t robots = 1;
    /// A client that has said nothing for so long gives way to the next; living ones send a pulse every
    /// second.
    std::chrono::milliseconds silence{10'000};
  };
  /// Told in serve() what happens. Robots are counted from 0.
  class Listener {
   public:
    virtual ~Listener() = default;
    virtual void clientCame(std::size_t robot, const std::string& address) = 0;
    virtual void packetCame(std::size_t robot, const Packet& packet) = 0;
    virtual void clientGone(std::size_t robot) = 0;
  };
  struct Statistics {
    std::string client;  ///< "127.0.0.1:50312"; empty: there is none
    PacketParser::Counters received;
    std::uint64_t receivedBytes = 0;  ///< of the present client
    std::uint64_t sentPackets = 0;
    std::uint64_t droppedPackets = 0;  ///< that the client did not read in time
    std::uint64_t clients = 0;         ///< that came, those that were refused apart
    std::uint64_t refused = 0;
  };

  /// Fails, naming address and port, if one cannot be opened; then none is.
  static Result<std::unique_ptr<RobotPorts>> open(const Options& options);
  ~RobotPorts();

  std::size_t robots() const;
  std::uint16_t port(std::size_t robot) const;
  /// Whether only programs of this machine can connect.
  bool loopbackOnly() const;
  /// Counts for the present client and all clients before it.
  Statistics statistics(std::size_t robot) const;

  /// Moves bytes, and tells of what came, until this instant; one that is past: only what is there already.
  /// To be called once a step of the simulation.
  void serve(Listener& listener, std::chrono::steady_clock::time_point until);
  /// To the robot's client; without one they are forgotten.
  void send(std::size_t robot, std::span<const Packet> packets);

 private:
  RobotPorts();
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace robotlink::arcos
