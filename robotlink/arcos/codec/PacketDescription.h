// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "robotlink/arcos/codec/Packet.h"

namespace robotlink::arcos {

/// A field of a packet for users: {"battery", "13", "V"}, {"flags", "0x0003 motors on, sonar array 1", ""}.
struct PacketField {
  std::string name;
  std::string value;
  /// Empty if there is none.
  std::string unit;
  bool operator==(const PacketField&) const = default;
};

/// The contents of a packet for users, field by field in the order of the wire, as shown by an inspector.
/// English.
struct PacketDescription {
  /// The name of the packet, such as "VEL2", "standard information", "command 111".
  std::string name;
  /// The effect of a command, in a sentence; empty for other packets.
  std::string summary;
  std::vector<PacketField> fields;
  /// Why the packet could not be decoded completely; empty if it could.
  std::string problem;

  /// A single line: "VEL 250 mm/s", "encoder: left 100 ticks, right 90 ticks"; truncated with "..." to about
  /// `length` characters.
  std::string line(std::size_t length = 120) const;
  bool operator==(const PacketDescription&) const = default;
};

/// Describes any packet; if it is unknown or damaged, a field contains its bytes.
PacketDescription describe(const Packet& packet, Direction direction);

}  // namespace robotlink::arcos
