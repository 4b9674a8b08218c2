// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "robotlink/arcos/codec/PacketParser.h"
#include "robotlink/base/Error.h"

namespace robotlink::arcos {

/// The TCP ports of simulated robots: one port a robot, one client at a time.
///
/// A port listens from open() to its end: when a client disconnects, the port is free for the next one. A
/// second client is accepted and closed immediately, which unmodified clients report as a lost connection and
/// which does not disturb the first one; but if the first one has been silent for long, as when its machine
/// has crashed, it is replaced. Data that a client does not read wait in a SendQueue, which drops old
/// packets, so that a slow reader gets recent ones.
///
/// A client cannot slow down other robots: each call of serve() processes at most kMaxBytes and
/// kMaxPackets of each port; the rest waits for the next call, first here, then in the client's system,
/// which then stops sending.
///
/// It has no thread: bytes are moved in serve() and send(), which one thread calls.
class RobotPorts {
 public:
  /// Limits of one port in one call of serve(). Real robots process about 300 packets a second.
  static constexpr std::size_t kMaxBytes = 16U << 10U;
  static constexpr std::size_t kMaxPackets = 64;
  struct Options {
    /// The local address; anything but loopback makes the robots reachable from the network.
    std::string address = "127.0.0.1";
    /// The port of the first robot; each further robot has the next one. 0: the system assigns free ports.
    std::uint16_t firstPort = 8101;
    std::size_t robots = 1;
    /// A client that has been silent for this long is replaced by the next one; live clients send a pulse
    /// every second.
    std::chrono::milliseconds silence{10'000};
    /// Says how long clients have been silent, and packets have waited. Tests have a clock of their own.
    std::function<std::chrono::steady_clock::time_point()> clock = std::chrono::steady_clock::now;
  };
  /// Called by serve(). Robots are numbered from 0.
  class Listener {
   public:
    virtual ~Listener() = default;
    virtual void clientCame(std::size_t robot, const std::string& address) = 0;
    virtual void packetCame(std::size_t robot, const Packet& packet) = 0;
    virtual void clientGone(std::size_t robot) = 0;
  };
  /// Counters of one port.
  struct Statistics {
    /// The client's address, "127.0.0.1:50312"; empty if there is none.
    std::string client;
    PacketParser::Counters received;
    /// The number of bytes from the present client.
    std::uint64_t receivedBytes = 0;
    std::uint64_t sentPackets = 0;
    /// Because the client did not read them in time.
    std::uint64_t droppedPackets = 0;
    /// Accepted clients, not counting refused ones.
    std::uint64_t clients = 0;
    /// Clients that were closed because another one was connected.
    std::uint64_t refused = 0;
  };

  /// Opens the ports. If one cannot be opened, none is, and the error names address and port.
  static Result<std::unique_ptr<RobotPorts>> open(const Options& options);
  ~RobotPorts();

  std::size_t robots() const;
  std::uint16_t port(std::size_t robot) const;
  /// Whether only programs on this machine can connect.
  bool loopbackOnly() const;
  /// The counters of the present client and of all before it, except for receivedBytes.
  Statistics statistics(std::size_t robot) const;

  /// Accepts clients, moves bytes and calls the listener until this instant; if it is past, processes only
  /// what is there already. Call it once a step of the simulation.
  void serve(Listener& listener, std::chrono::steady_clock::time_point until);
  /// Sends packets to the robot's client; dropped if there is none.
  void send(std::size_t robot, std::span<const Packet> packets);

 private:
  RobotPorts();
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace robotlink::arcos
