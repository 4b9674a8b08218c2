// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string>

#include "robotlink/arcos/codec/PacketDescription.h"
#include "robotlink/base/Clock.h"

namespace widgets {

/// Something that went over the line to a robot, decoded for people. A plain value.
struct PacketEntry {
  enum class Kind : std::uint8_t { kPacket, kNewConnection, kClosed };
  Kind kind = Kind::kPacket;
  robotlink::Instant time;
  bool fromRobot = false;
  bool damaged = false;
  std::string bytes;  ///< as they were, with header and checksum
  QString name;       ///< "VEL2", "standard information"; of damage what is wrong with it
  QString summary;    ///< one line
};

/// Decodes `bytes`; that they are damaged is found by itself, `damaged` says what whoever told them knows
/// besides.
PacketEntry packetEntry(robotlink::Instant time, bool fromRobot, std::string bytes, bool damaged = false);
/// Field by field; of damaged bytes the problem.
robotlink::arcos::PacketDescription describePacket(const PacketEntry& entry);
/// 0 to 255; -1 if it is no whole packet.
int packetId(const PacketEntry& entry);
/// "fa fb 03 00 00 00"
QString hexText(const std::string& bytes);

}  // namespace widgets
