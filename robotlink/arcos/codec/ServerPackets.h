// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <variant>

#include "robotlink/arcos/codec/Configuration.h"
#include "robotlink/arcos/codec/Identity.h"
#include "robotlink/arcos/codec/LaserPacket.h"
#include "robotlink/arcos/codec/SensorPackets.h"
#include "robotlink/arcos/codec/SimulatorPackets.h"
#include "robotlink/arcos/codec/StandardInformation.h"
#include "robotlink/base/Error.h"

// Every packet that a robot sends, both ways: toPacket() and a decode function for each.
//
// A decoder fails, with a sentence, where a packet of its number lacks what must be there. Whatever it takes
// is written back byte for byte by toPacket(); what a packet has beyond what is known is kept. Numbers wider
// than a packet's field and strings past their first NUL are cut; lists longer than their count can say as
// well.
namespace robotlink::arcos {

/// An echo of SYNC0 or SYNC1, or a packet whose layout is not known here.
struct RawPacket {
  Packet packet;
  bool operator==(const RawPacket&) const = default;
};

using ServerPacket =
    std::variant<RawPacket, Identity, StandardInformation, Configuration, EncoderPacket, IoPacket, GyroPacket,
                 ImuPacket, AuxSerialPacket, CompassPacket, GripperPacket, JoystickPacket, BatteryPacket,
                 LaserPacket, SimulatorStatus, SimulatorInfo, MapChanged>;

Packet toPacket(const Identity& identity);
Packet toPacket(const Configuration& configuration);
Packet toPacket(const EncoderPacket& encoder);
Packet toPacket(const IoPacket& io);
Packet toPacket(const GyroPacket& gyro);
Packet toPacket(const ImuPacket& imu);
Packet toPacket(const AuxSerialPacket& serial);
Packet toPacket(const CompassPacket& compass);
Packet toPacket(const GripperPacket& gripper);
Packet toPacket(const JoystickPacket& joystick);
Packet toPacket(const BatteryPacket& battery);
Packet toPacket(const LaserPacket& laser);
Packet toPacket(const SimulatorStatus& status);
Packet toPacket(const SimulatorInfo& info);
Packet toPacket(const MapChanged& changed);
Packet toPacket(const ServerPacket& packet);

Result<Identity> decodeIdentity(const Packet& packet);
Result<Configuration> decodeConfiguration(const Packet& packet);
Result<EncoderPacket> decodeEncoder(const Packet& packet);
Result<IoPacket> decodeIo(const Packet& packet);
Result<GyroPacket> decodeGyro(const Packet& packet);
Result<ImuPacket> decodeImu(const Packet& packet);
Result<AuxSerialPacket> decodeAuxSerial(const Packet& packet);
Result<CompassPacket> decodeCompass(const Packet& packet);
Result<GripperPacket> decodeGripper(const Packet& packet);
Result<JoystickPacket> decodeJoystick(const Packet& packet);
Result<BatteryPacket> decodeBattery(const Packet& packet);
Result<LaserPacket> decodeLaser(const Packet& packet);
Result<SimulatorStatus> decodeSimulatorStatus(const Packet& packet);
Result<SimulatorInfo> decodeSimulatorInfo(const Packet& packet);
Result<MapChanged> decodeMapChanged(const Packet& packet);

/// Whatever it is, by its number.
Result<ServerPacket> decodeServerPacket(const Packet& packet);

/// "standard information", "packet 0x7b" if the number is unknown.
std::string nameOfServerPacket(std::uint8_t id);

}  // namespace robotlink::arcos
