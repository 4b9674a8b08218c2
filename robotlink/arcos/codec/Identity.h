// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "robotlink/arcos/codec/Packet.h"

namespace robotlink::arcos {

/// The robot's reply to SYNC2, the end of the handshake.
struct Identity {
  static constexpr std::uint8_t kId = 2;
  /// Given by the robot's owner.
  std::string name;
  std::string robotClass = "Pioneer";
  /// The kind of robot: "p3at-sh".
  std::string subclass;
  /// Data after the known fields.
  Bytes rest;
  bool operator==(const Identity&) const = default;
};

}  // namespace robotlink::arcos
