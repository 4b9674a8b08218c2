// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "robotlink/arcos/codec/Packet.h"

namespace robotlink::arcos {

/// A field of a packet, for people: {"battery", "13", "V"}, {"flags", "0x0003 motors on, sonar array 1", ""}.
struct PacketField {
  std::string name;
  std::string value;
  std::string unit;  ///< empty if there is none
  bool operator==(const PacketField&) const = default;
};

/// What a packet says, field by field in the order of the wire: what an inspector shows. English.
struct PacketDescription {
  std::string name;     ///< "VEL2", "standard information", "command 111"
  std::string summary;  ///< of commands a sentence on what they do, else empty
  std::vector<PacketField> fields;
  std::string problem;  ///< why it could not be read whole; empty if it could

  /// "VEL 250 mm/s", "encoder: left 100 ticks, right 90 ticks"; at most about `length` characters, then
  /// "...".
  std::string line(std::size_t length = 120) const;
  bool operator==(const PacketDescription&) const = default;
};

/// Any packet; of those that are not known, or that are damaged, the bytes are a field.
PacketDescription describe(const Packet& packet, Direction direction);

}  // namespace robotlink::arcos
