// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "robotlink/arcos/codec/Packet.h"

namespace robotlink::arcos {

/// The last answer of the handshake: packet 2.
struct Identity {
  static constexpr std::uint8_t kId = 2;
  std::string name;  ///< given by its owner
  std::string robotClass = "Pioneer";
  std::string subclass;  ///< "p3at-sh"
  Bytes rest;
  bool operator==(const Identity&) const = default;
};

}  // namespace robotlink::arcos
