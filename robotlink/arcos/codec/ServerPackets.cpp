// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/codec/ServerPackets.h"

#include <cstdio>

#include "robotlink/arcos/codec/ConfigurationFields.h"
#include "robotlink/arcos/codec/ServerPacketFields.h"
#include "robotlink/arcos/codec/WireFields.h"

namespace robotlink::arcos {
namespace {

template <typename T>
Packet written(std::uint8_t id, const T& value) {
  Packet packet{id, {}};
  FieldWriter writer(packet.data);
  visitFields(value, writer);
  writer.finish();
  return packet;
}

tl::unexpected<Error> wrongPacket(const Packet& packet, const std::string& wanted) {
  return failure("arcos.wrong-packet", "this is no " + wanted + " but " + nameOfServerPacket(packet.id));
}

template <typename T>
Result<T> read(const Packet& packet, T value = {}) {
  FieldReader reader(packet.data);
  visitFields(value, reader);
  if (reader.ok()) return value;
  return failure("arcos.short-packet", "the " + nameOfServerPacket(packet.id) + " packet of " +
                                           std::to_string(packet.data.size()) + " bytes ends before its " +
                                           reader.missing());
}

template <typename T>
Result<T> readOnly(const Packet& packet) {
  if (packet.id != T::kId) return wrongPacket(packet, nameOfServerPacket(T::kId));
  return read<T>(packet);
}

bool isAuxSerial(std::uint8_t id) {
  return std::find(std::begin(AuxSerialPacket::kIds), std::end(AuxSerialPacket::kIds), id) !=
         std::end(AuxSerialPacket::kIds);
}

template <typename T>
Result<ServerPacket> widened(Result<T> result) {
  if (!result) return tl::unexpected(std::move(result.error()));
  return ServerPacket(std::move(*result));
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

}  // namespace

Packet toPacket(const Identity& identity) {
  return written(Identity::kId, identity);
}
Packet toPacket(const StandardInformation& information) {
  return written(information.moving ? StandardInformation::kMovingId : StandardInformation::kStandingId,
                 information);
}
Packet toPacket(const EncoderPacket& encoder) {
  return written(EncoderPacket::kId, encoder);
}
Packet toPacket(const IoPacket& io) {
  return written(IoPacket::kId, io);
}
Packet toPacket(const GyroPacket& gyro) {
  return written(GyroPacket::kId, gyro);
}
Packet toPacket(const ImuPacket& imu) {
  return written(ImuPacket::kId, imu);
}
Packet toPacket(const AuxSerialPacket& serial) {
  const int port = std::clamp(serial.port, 1, 3);
  return written(AuxSerialPacket::kIds[port - 1], serial);
}
Packet toPacket(const CompassPacket& compass) {
  return written(CompassPacket::kId, compass);
}
Packet toPacket(const GripperPacket& gripper) {
  return written(GripperPacket::kId, gripper);
}
Packet toPacket(const JoystickPacket& joystick) {
  return written(JoystickPacket::kId, joystick);
}
Packet toPacket(const LaserPacket& laser) {
  return written(laser.extended ? LaserPacket::kExtendedId : LaserPacket::kPlainId, laser);
}
Packet toPacket(const SimulatorStatus& status) {
  return written(SimulatorStatus::kId, status);
}
Packet toPacket(const SimulatorInfo& info) {
  return written(SimulatorInfo::kId, info);
}
Packet toPacket(const MapChanged& changed) {
  return written(MapChanged::kId, changed);
}
Packet toPacket(const ServerPacket& packet) {
  return std::visit(
      [](const auto& value) {
        if constexpr (std::is_same_v<std::decay_t<decltype(value)>, RawPacket>) {
          return value.packet;
        } else {
          return toPacket(value);
        }
      },
      packet);
}

Result<Identity> decodeIdentity(const Packet& packet) {
  return readOnly<Identity>(packet);
}
Result<StandardInformation> decodeStandardInformation(const Packet& packet) {
  const bool moving = packet.id == StandardInformation::kMovingId;
  if (!moving && packet.id != StandardInformation::kStandingId)
    return wrongPacket(packet, "standard information");
  StandardInformation information;
  information.moving = moving;
  return read(packet, std::move(information));
}
Result<EncoderPacket> decodeEncoder(const Packet& packet) {
  return readOnly<EncoderPacket>(packet);
}
Result<IoPacket> decodeIo(const Packet& packet) {
  return readOnly<IoPacket>(packet);
}
Result<GyroPacket> decodeGyro(const Packet& packet) {
  return readOnly<GyroPacket>(packet);
}
Result<ImuPacket> decodeImu(const Packet& packet) {
  return readOnly<ImuPacket>(packet);
}
Result<AuxSerialPacket> decodeAuxSerial(const Packet& packet) {
  if (!isAuxSerial(packet.id)) return wrongPacket(packet, "serial port");
  const auto* found =
      std::find(std::begin(AuxSerialPacket::kIds), std::end(AuxSerialPacket::kIds), packet.id);
  return AuxSerialPacket{static_cast<int>(found - std::begin(AuxSerialPacket::kIds)) + 1, packet.data};
}
Result<CompassPacket> decodeCompass(const Packet& packet) {
  return readOnly<CompassPacket>(packet);
}
Result<GripperPacket> decodeGripper(const Packet& packet) {
  return readOnly<GripperPacket>(packet);
}
Result<JoystickPacket> decodeJoystick(const Packet& packet) {
  return readOnly<JoystickPacket>(packet);
}
Result<LaserPacket> decodeLaser(const Packet& packet) {
  const bool extended = packet.id == LaserPacket::kExtendedId;
  if (!extended && packet.id != LaserPacket::kPlainId) return wrongPacket(packet, "laser");
  LaserPacket laser;
  laser.extended = extended;
  return read(packet, std::move(laser));
}
Result<SimulatorStatus> decodeSimulatorStatus(const Packet& packet) {
  return readOnly<SimulatorStatus>(packet);
}
Result<SimulatorInfo> decodeSimulatorInfo(const Packet& packet) {
  return readOnly<SimulatorInfo>(packet);
}
Result<MapChanged> decodeMapChanged(const Packet& packet) {
  return readOnly<MapChanged>(packet);
}

// The packet itself says how many bytes a battery has.
Packet toPacket(const BatteryPacket& battery) {
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

Result<BatteryPacket> decodeBattery(const Packet& packet) {
  if (packet.id != BatteryPacket::kId) return wrongPacket(packet, nameOfServerPacket(BatteryPacket::kId));
  BatteryPacket battery;
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

Result<ServerPacket> decodeServerPacket(const Packet& packet) {
  switch (packet.id) {
    case Identity::kId:
      return widened(decodeIdentity(packet));
    case StandardInformation::kStandingId:
    case StandardInformation::kMovingId:
      return widened(decodeStandardInformation(packet));
    case Configuration::kId:
      return widened(decodeConfiguration(packet));
    case EncoderPacket::kId:
      return widened(decodeEncoder(packet));
    case IoPacket::kId:
      return widened(decodeIo(packet));
    case GyroPacket::kId:
      return widened(decodeGyro(packet));
    case ImuPacket::kId:
      return widened(decodeImu(packet));
    case CompassPacket::kId:
      return widened(decodeCompass(packet));
    case GripperPacket::kId:
      return widened(decodeGripper(packet));
    case JoystickPacket::kId:
      return widened(decodeJoystick(packet));
    case BatteryPacket::kId:
      return widened(decodeBattery(packet));
    case LaserPacket::kPlainId:
    case LaserPacket::kExtendedId:
      return widened(decodeLaser(packet));
    case SimulatorStatus::kId:
      return widened(decodeSimulatorStatus(packet));
    case SimulatorInfo::kId:
      return widened(decodeSimulatorInfo(packet));
    case MapChanged::kId:
      return widened(decodeMapChanged(packet));
    default:
      break;
  }
  if (isAuxSerial(packet.id)) return widened(decodeAuxSerial(packet));
  return ServerPacket(RawPacket{packet});
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

Packet toPacket(const Configuration& configuration) {
  Packet packet{Configuration::kId, {}};
  packet.data.reserve(128);
  FieldWriter writer(packet.data);
  PrefixWriter prefix{writer, configuration.fieldCount};
  visitConfigurationFields(configuration, prefix);
  writer.rest(configuration.rest);
  writer.finish();
  return packet;
}

Result<Configuration> decodeConfiguration(const Packet& packet) {
  if (packet.id != Configuration::kId) {
    return failure("arcos.wrong-packet",
                   "this is not a configuration but packet " + std::to_string(packet.id));
  }
  Configuration configuration;
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

}  // namespace robotlink::arcos
