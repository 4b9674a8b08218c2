// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "robotlink/arcos/codec/Packet.h"

namespace robotlink::arcos {

/// A part of a scan of a simulator's laser: id 0x60 (plain) with the robot's pose, or 0x61 (extended) with
/// reflectances. Reading 0 is at the right end of the field of view, the others follow counterclockwise. A
/// scan is complete when first + readings.size() >= total.
struct LaserPacket {
  static constexpr std::uint8_t kPlainId = 0x60;
  static constexpr std::uint8_t kExtendedId = 0x61;
  static constexpr std::uint8_t kIds[] = {kPlainId, kExtendedId};
  /// The number of readings in a full packet, which is then shorter than kMaxSentCount.
  static constexpr std::size_t kMaxReadings = 32;

  /// A reading of one beam.
  struct Reading {
    std::uint16_t rangeMm = 0;
    /// In plain packets 0.
    std::uint8_t reflectance = 0;
    /// Always 0.
    std::array<std::uint8_t, 2> reserved = {};
    bool operator==(const Reading&) const = default;
  };

  bool extended = true;
  /// Number of readings in the scan, and index of the first one in this packet.
  std::uint16_t total = 0;
  std::uint16_t first = 0;
  std::vector<Reading> readings;

  // Only in plain packets: the robot's pose by odometry.
  std::int16_t xMm = 0;
  std::int16_t yMm = 0;
  std::int16_t headingDeg = 0;

  // Only in extended packets.
  std::uint8_t device = 0;
  /// Bit 0: the robot moved.
  std::uint8_t flags = 0;
  /// Data after the known fields.
  Bytes rest;

  bool operator==(const LaserPacket&) const = default;
};

}  // namespace robotlink::arcos
