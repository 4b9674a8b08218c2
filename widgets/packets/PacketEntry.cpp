// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/packets/PacketEntry.h"

#include <QByteArray>
#include <QObject>

#include "robotlink/arcos/codec/PacketParser.h"
#include "widgets/Counted.h"

namespace widgets {
namespace {

namespace arcos = robotlink::arcos;

/// The one packet that the bytes are, or what is wrong with them.
arcos::PacketParser::Found parsed(const std::string& bytes) {
  arcos::DamagedBytes whole;
  whole.bytes.assign(bytes.begin(), bytes.end());
  arcos::PacketParser parser;
  parser.push(whole.bytes);
  auto found = parser.next();
  if (!found) {
    parser.dropPartial();
    found = parser.next();
  }
  if (!found) return whole;
  if (const auto* packet = std::get_if<arcos::Packet>(&*found)) {
    if (packet->count() + 3 == bytes.size()) return *packet;
    return whole;  // more than one packet, or trailing bytes
  }
  whole.kind = std::get<arcos::DamagedBytes>(*found).kind;
  return whole;
}

/// The contents of a packet without its name, which has a column of its own; if it has none, its purpose.
QString saying(const arcos::PacketDescription& description) {
  std::string line = description.line(240);
  if (line.starts_with(description.name)) line.erase(0, description.name.size());
  const std::size_t begin = line.find_first_not_of(": ");
  return QString::fromStdString(begin == std::string::npos ? description.summary : line.substr(begin));
}

arcos::Direction directionOf(bool fromRobot) {
  return fromRobot ? arcos::Direction::kFromRobot : arcos::Direction::kFromClient;
}

}  // namespace

PacketEntry packetEntry(robotlink::Instant time, bool fromRobot, std::string bytes, bool damaged) {
  PacketEntry entry;
  entry.time = time;
  entry.fromRobot = fromRobot;
  entry.damaged = damaged;
  const auto found = parsed(bytes);
  if (const auto* packet = std::get_if<arcos::Packet>(&found)) {
    const arcos::PacketDescription description = arcos::describe(*packet, directionOf(fromRobot));
    entry.name = QString::fromStdString(description.name);
    entry.summary = saying(description);
    entry.damaged = damaged || !description.problem.empty();
  } else {
    entry.damaged = true;
    entry.name = QString::fromLatin1(arcos::describe(std::get<arcos::DamagedBytes>(found).kind));
    entry.summary = counted(bytes.size(), QObject::tr("1 byte"), QObject::tr("%1 bytes"));
  }
  entry.bytes = std::move(bytes);
  return entry;
}

arcos::PacketDescription describePacket(const PacketEntry& entry) {
  const auto found = parsed(entry.bytes);
  if (const auto* packet = std::get_if<arcos::Packet>(&found))
    return arcos::describe(*packet, directionOf(entry.fromRobot));
  arcos::PacketDescription description;
  description.name = entry.name.toStdString();
  description.problem = arcos::describe(std::get<arcos::DamagedBytes>(found).kind);
  return description;
}

int packetId(const PacketEntry& entry) {
  const auto found = parsed(entry.bytes);
  const auto* packet = std::get_if<arcos::Packet>(&found);
  return packet == nullptr ? -1 : packet->id;
}

QString hexText(const std::string& bytes) {
  return QString::fromLatin1(QByteArray(bytes.data(), static_cast<int>(bytes.size())).toHex(' '));
}

}  // namespace widgets
