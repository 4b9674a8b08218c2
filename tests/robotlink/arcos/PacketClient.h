// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "robotlink/arcos/codec/Command.h"
#include "robotlink/arcos/codec/ServerPackets.h"
#include "robotlink/base/Clock.h"

namespace robotlink::arcos {

/// A client of a robot that stores what it receives; how it is connected is up to the class derived from it.
class PacketClient {
 public:
  virtual ~PacketClient() = default;

  virtual void send(const Packet& packet) = 0;
  void send(CommandId id) { send(toPacket(command(id))); }
  void send(CommandId id, int argument) { send(toPacket(command(id, argument))); }
  void send(CommandId id, std::string argument) { send(toPacket(command(id, std::move(argument)))); }
  /// Sends the three SYNC packets and OPEN.
  void handshake() {
    for (const auto id : {CommandId::kSync0, CommandId::kSync1, CommandId::kSync2}) send(id);
    send(CommandId::kOpen, 1);
  }

  /// All packets received so far, with the times at which they were read.
  std::vector<Packet> received;
  std::vector<Instant> receivedAt;

  /// The received packets with an id.
  std::vector<Packet> of(std::uint8_t id) const {
    std::vector<Packet> found;
    for (const Packet& packet : received) {
      if (packet.id == id) found.push_back(packet);
    }
    return found;
  }
  /// All standard information packets received.
  std::vector<StandardInformation> information() const {
    std::vector<StandardInformation> found;
    for (const Packet& packet : received) {
      if (hasId<StandardInformation>(packet.id)) found.push_back(decode<StandardInformation>(packet).value());
    }
    return found;
  }
  /// Clears the received packets.
  void forget() {
    received.clear();
    receivedAt.clear();
  }

 protected:
  void store(Packet packet, Instant now) {
    received.push_back(std::move(packet));
    receivedAt.push_back(now);
  }
};

}  // namespace robotlink::arcos
