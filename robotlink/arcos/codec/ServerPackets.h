// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <variant>

#include "robotlink/arcos/codec/Configuration.h"
#include "robotlink/arcos/codec/Identity.h"
#include "robotlink/arcos/codec/LaserPacket.h"
#include "robotlink/arcos/codec/SensorPackets.h"
#include "robotlink/arcos/codec/SimulatorPackets.h"
#include "robotlink/arcos/codec/StandardInformation.h"
#include "robotlink/base/Error.h"

// Encoding and decoding of every packet that a robot sends: toPacket() and decode() for each. Pure functions.
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

/// The name for users: "standard information", or "packet 0x7b" if the id is unknown.
std::string nameOfServerPacket(std::uint8_t id);

/// Encodes a packet with its own id.
Packet toPacket(const ServerPacket& packet);

/// Decodes any packet by its id; unknown ids give a RawPacket.
Result<ServerPacket> decodeServerPacket(const Packet& packet);

/// Whether packets of this type have the id.
template <typename T>
constexpr bool hasId(std::uint8_t id) {
  if constexpr (requires { T::kIds; }) {
    return std::ranges::find(T::kIds, id) != std::end(T::kIds);
  } else {
    return id == T::kId;
  }
}

/// Decodes a packet whose id is known to be that of one of the types of ServerPacket. The error names the
/// missing field.
template <typename T>
Result<T> decode(const Packet& packet) {
  if (!hasId<T>(packet.id))
    return failure("arcos.wrong-packet",
                   "this is another packet than expected: " + nameOfServerPacket(packet.id));
  auto decoded = decodeServerPacket(packet);
  if (!decoded) return tl::unexpected(std::move(decoded.error()));
  return std::get<T>(std::move(*decoded));
}

}  // namespace robotlink::arcos
