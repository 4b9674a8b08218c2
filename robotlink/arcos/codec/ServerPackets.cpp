// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/codec/ServerPackets.h"

#include <cstdio>
#include <optional>

#include "robotlink/arcos/codec/ConfigurationFields.h"
#include "robotlink/arcos/codec/ServerPacketFields.h"
#include "robotlink/arcos/codec/WireFields.h"

namespace robotlink::arcos {
namespace {

/// Writes a packet that consists of its fields.
template <typename T>
Packet withFields(std::uint8_t id, const T& value) {
  Packet packet{id, {}};
  FieldWriter writer(packet.data);
  visitFields(value, writer);
  writer.finish();
  return packet;
}

/// Reads fields until the data end.
struct PrefixReader {
  FieldReader& reader;
  int count = 0;
  bool ended = false;

  template <typename T>
  void operator()(const char*, T& value, const char* = "") {
    value = T{};
    ended = ended || !reader.take(value);
    if (!ended) ++count;
  }
};

struct PrefixWriter {
  FieldWriter& writer;
  int left;

  template <typename T>
  void operator()(const char* name, const T& value, const char* = "") {
    if (left-- > 0) writer(name, value);
  }
};

template <typename T>
Packet written(const T& packet) {
  return withFields(T::kId, packet);
}
Packet written(const RawPacket& raw) {
  return raw.packet;
}
Packet written(const StandardInformation& information) {
  return withFields(information.moving ? StandardInformation::kMovingId : StandardInformation::kStandingId,
                    information);
}
Packet written(const AuxSerialPacket& serial) {
  return withFields(AuxSerialPacket::kIds[std::clamp(serial.port, 1, 3) - 1], serial);
}
Packet written(const LaserPacket& laser) {
  return withFields(laser.extended ? LaserPacket::kExtendedId : LaserPacket::kPlainId, laser);
}

// The packet itself says how many bytes a battery has.
Packet written(const BatteryPacket& battery) {
  const std::uint8_t bytes = battery.batteries.empty()
                                 ? battery.bytesPerBattery
                                 : std::max(battery.bytesPerBattery, BatteryPacket::kKnownBytes);
  Packet packet{BatteryPacket::kId, {}};
  FieldWriter writer(packet.data);
  writer.size<std::uint8_t>("batteries", battery.batteries);
  writer("bytes of a battery", bytes);
  for (const BatteryPacket::Battery& one : battery.batteries) {
    visitFields(one, writer);
    writer.bytes(one.more, static_cast<std::size_t>(bytes - BatteryPacket::kKnownBytes));
  }
  writer.rest(battery.rest);
  writer.finish();
  return packet;
}

Packet written(const Configuration& configuration) {
  Packet packet{Configuration::kId, {}};
  packet.data.reserve(128);
  FieldWriter writer(packet.data);
  PrefixWriter prefix{writer, configuration.fieldCount};
  visitConfigurationFields(configuration, prefix);
  writer.rest(configuration.rest);
  writer.finish();
  return packet;
}

template <typename T>
Result<T> read(const Packet& packet, T value) {
  FieldReader reader(packet.data);
  visitFields(value, reader);
  if (reader.ok()) return value;
  return failure("arcos.short-packet", "the " + nameOfServerPacket(packet.id) + " packet of " +
                                           std::to_string(packet.data.size()) + " bytes ends before its " +
                                           reader.missing());
}

Result<StandardInformation> read(const Packet& packet, StandardInformation information) {
  information.moving = packet.id == StandardInformation::kMovingId;
  return read<StandardInformation>(packet, std::move(information));
}

Result<AuxSerialPacket> read(const Packet& packet, AuxSerialPacket serial) {
  const auto* found = std::ranges::find(AuxSerialPacket::kIds, packet.id);
  serial.port = static_cast<int>(found - std::begin(AuxSerialPacket::kIds)) + 1;
  serial.bytes = packet.data;
  return serial;
}

Result<LaserPacket> read(const Packet& packet, LaserPacket laser) {
  laser.extended = packet.id == LaserPacket::kExtendedId;
  return read<LaserPacket>(packet, std::move(laser));
}

Result<BatteryPacket> read(const Packet& packet, BatteryPacket battery) {
  FieldReader reader(packet.data);
  reader.size<std::uint8_t>("batteries", battery.batteries);
  reader("bytes of a battery", battery.bytesPerBattery);
  const int more = battery.bytesPerBattery - BatteryPacket::kKnownBytes;
  if (reader.ok() && more < 0 && !battery.batteries.empty()) {
    return failure("arcos.short-packet", "the battery packet has " + std::to_string(battery.bytesPerBattery) +
                                             " bytes for each battery; at least 5 are needed");
  }
  for (BatteryPacket::Battery& one : battery.batteries) {
    visitFields(one, reader);
    reader.bytes(one.more, static_cast<std::size_t>(more));
  }
  reader.rest(battery.rest);
  if (reader.ok()) return battery;
  return failure("arcos.short-packet", "the battery packet ends before its last battery");
}

Result<Configuration> read(const Packet& packet, Configuration configuration) {
  FieldReader reader(packet.data);
  PrefixReader prefix{reader};
  visitConfigurationFields(configuration, prefix);
  configuration.fieldCount = prefix.count;
  reader.rest(configuration.rest);
  if (prefix.count < 3) {
    return failure("arcos.short-packet", "the robot's configuration ends before its serial number");
  }
  return configuration;
}

/// Reads a packet as that of the types whose id it has.
template <typename... T>
Result<ServerPacket> readAny(const Packet& packet, const std::variant<RawPacket, T...>*) {
  std::optional<Result<ServerPacket>> result;
  const auto readAs = [&]<typename One>() {
    if (!hasId<One>(packet.id)) return false;
    result = read(packet, One{}).map([](One value) { return ServerPacket(std::move(value)); });
    return true;
  };
  static_cast<void>((readAs.template operator()<T>() || ...));
  return result ? std::move(*result) : ServerPacket(RawPacket{packet});
}

}  // namespace

Packet toPacket(const ServerPacket& packet) {
  return std::visit([](const auto& value) { return written(value); }, packet);
}

Result<ServerPacket> decodeServerPacket(const Packet& packet) {
  return readAny(packet, static_cast<const ServerPacket*>(nullptr));
}

std::string nameOfServerPacket(std::uint8_t id) {
  static constexpr struct {
    std::uint8_t id;
    const char* name;
  } kNames[] = {{0x00, "SYNC0 echo"},
                {0x01, "SYNC1 echo"},
                {0x02, "identity"},
                {0x20, "configuration"},
                {0x32, "standard information"},
                {0x33, "standard information"},
                {0x60, "laser"},
                {0x61, "laser"},
                {0x62, "simulator status"},
                {0x63, "simulator info"},
                {0x66, "map changed"},
                {0x7B, "acceleration"},
                {0x7C, "torque"},
                {0x90, "encoder"},
                {0x95, "heading"},
                {0x96, "logger"},
                {0x98, "gyro"},
                {0x9A, "IMU"},
                {0xA0, "arm"},
                {0xA1, "arm info"},
                {0xB0, "serial port AUX1"},
                {0xB8, "serial port AUX2"},
                {0xC0, "compass"},
                {0xC8, "serial port AUX3"},
                {0xD0, "playlist"},
                {0xD3, "MARC"},
                {0xD5, "absolute maxima"},
                {0xDA, "wheels"},
                {0xE0, "gripper"},
                {0xF0, "inputs and outputs"},
                {0xF8, "joystick"},
                {0xFA, "battery"},
                {0xFE, "controller reset"},
                {0xFF, "controller reset"}};
  for (const auto& [known, name] : kNames) {
    if (known == id) return name;
  }
  char text[16];
  std::snprintf(text, sizeof text, "packet 0x%02x", static_cast<unsigned>(id));
  return text;
}

}  // namespace robotlink::arcos
