// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string>

#include "robotlink/arcos/codec/PacketDescription.h"
#include "robotlink/base/Clock.h"

namespace widgets {

/// An event on the line to a robot: a packet, or the beginning or end of a connection, decoded for display.
/// A plain value.
struct PacketEntry {
  /// A packet, or a marker between packets. Markers have a time and a name only.
  enum class Kind : std::uint8_t { kPacket, kNewConnection, kClosed };
  Kind kind = Kind::kPacket;
  /// The time at which the platform sent or received it.
  robotlink::Instant time;
  bool fromRobot = false;
  /// The bytes are no valid packet, or decoding found a problem.
  bool damaged = false;
  /// The raw bytes with header and checksum.
  std::string bytes;
  /// "VEL2", "standard information"; for damaged bytes the kind of damage.
  QString name;
  /// The contents in one line.
  QString summary;
};

/// Decodes `bytes`. Damage is detected here; `damaged` adds what the platform reported.
PacketEntry packetEntry(robotlink::Instant time, bool fromRobot, std::string bytes, bool damaged = false);
/// Decodes the packet field by field; for damaged bytes only the problem.
robotlink::arcos::PacketDescription describePacket(const PacketEntry& entry);
/// The packet's id or command number, 0 to 255; -1 if the bytes are not exactly one packet.
int packetId(const PacketEntry& entry);
/// "fa fb 03 00 00 00"
QString hexText(const std::string& bytes);

}  // namespace widgets
