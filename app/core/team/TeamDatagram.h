// SPDX-License-Identifier: GPL-3.0-or-later
// Encodes and decodes the UDP datagrams that robots of a team exchange: one message in each datagram.
//
//     4 bytes  "RCTM"
//     2 bytes  version: 1
//     2 bytes  length of the rest behind the checksum, at most kMaxTeamBytes
//     4 bytes  CRC-32 of the rest (zlib's), as numbers are little-endian
//     the rest robotcontrol.TeamMessage, serialized
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "robotlink/base/Error.h"

namespace robotcontrol {
class TeamMessage;
}

namespace app {

/// The most that a message may take; with its head it fits into a packet of Ethernet.
inline constexpr std::size_t kMaxTeamBytes = 1400;

/// Fails if the message is too long.
robotlink::Result<std::vector<std::uint8_t>> teamDatagram(const robotcontrol::TeamMessage& message);
/// Fails if these bytes are not a datagram, are of another version, or damaged, or have a wrong length;
/// or if sender or team are missing, or a number is invalid.
robotlink::Result<std::shared_ptr<const robotcontrol::TeamMessage>> teamMessageIn(
    std::span<const std::uint8_t> datagram);

}  // namespace app
