// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"

namespace app {

/// A UDP socket that sends to the other robots of a team, and hears them. Nothing waits: what cannot be sent
/// now is lost. One thread.
class TeamSocket {
 public:
  /// Hears at a port of this machine, 0: any; sends to these ("HOST:PORT"; a broadcast address reaches all of
  /// a network). Fails if the port is taken, or a peer makes no sense or is not found.
  static robotlink::Result<std::unique_ptr<TeamSocket>> open(std::uint16_t port,
                                                             const std::vector<std::string>& peers);
  ~TeamSocket();
  TeamSocket(const TeamSocket&) = delete;
  TeamSocket& operator=(const TeamSocket&) = delete;

  /// The port at which it hears.
  std::uint16_t port() const { return port_; }
  /// To all peers.
  void send(std::span<const std::uint8_t> datagram);
  /// The next datagram that has arrived; unset if there is none.
  std::optional<std::vector<std::uint8_t>> receive();

 private:
  struct Peer;
  TeamSocket();

  int socket_ = -1;
  std::uint16_t port_ = 0;
  std::vector<Peer> peers_;
};

}  // namespace app
