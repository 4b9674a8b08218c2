// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "robotlink/arcos/codec/Packet.h"

namespace robotlink::arcos {

/// A part of a scan of a simulator's laser: 0x60 (plain) with the robot's pose, or 0x61 (extended) with
/// reflectances. Reading 0 is where the field of view begins (right), the others follow counter-clockwise; a
/// scan is complete when first + ranges >= total.
struct LaserPacket {
  static constexpr std::uint8_t kPlainId = 0x60;
  static constexpr std::uint8_t kExtendedId = 0x61;
  static constexpr std::size_t kMostReadings = 32;

  struct Reading {
    std::uint16_t rangeMm = 0;
    std::uint8_t reflectance = 0;               ///< 0 in plain packets
    std::array<std::uint8_t, 2> reserved = {};  ///< 0
    bool operator==(const Reading&) const = default;
  };

  bool extended = true;
  std::uint16_t total = 0;
  std::uint16_t first = 0;
  std::vector<Reading> readings;

  // Plain packets only: where the robot was.
  std::int16_t xMm = 0;
  std::int16_t yMm = 0;
  std::int16_t headingDeg = 0;

  // Extended packets only.
  std::uint8_t device = 0;
  std::uint8_t flags = 0;  ///< bit 0: the robot moved
  Bytes rest;

  bool operator==(const LaserPacket&) const = default;
};

}  // namespace robotlink::arcos
