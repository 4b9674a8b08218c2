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

// Encoding and decoding of every packet that a robot sends: toPacket() and a decode function for each. Pure
// functions.
//
// A decoder fails, with a sentence, if required data are missing. toPacket() restores a decoded packet byte
// for byte; data after the known fields are preserved. Numbers too large for their field, strings after their
// first NUL, and lists longer than their count allows are truncated.
namespace robotlink::arcos {

/// A packet that is not decoded: an echo of SYNC0 or SYNC1, or one whose layout is not known here.
struct RawPacket {
  Packet packet;
  bool operator==(const RawPacket&) const = default;
};

/// Any packet of a robot.
using ServerPacket =
    std::variant<RawPacket, Identity, StandardInformation, Configuration, EncoderPacket, IoPacket, GyroPacket,
                 ImuPacket, AuxSerialPacket, CompassPacket, GripperPacket, JoystickPacket, BatteryPacket,
                 LaserPacket, SimulatorStatus, SimulatorInfo, MapChanged>;

/// Encodes a packet with its own id.
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

/// Decodes a packet whose id is known to fit. The error names the missing field.
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

/// Decodes any packet by its id; unknown ids give a RawPacket.
Result<ServerPacket> decodeServerPacket(const Packet& packet);

/// The name for users: "standard information", or "packet 0x7b" if the id is unknown.
std::string nameOfServerPacket(std::uint8_t id);

}  // namespace robotlink::arcos
