// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "robotlink/arcos/codec/Packet.h"

// What only simulators send. `rest` is what stands behind all that is known.
namespace robotlink::arcos {

/// The answer to SIM_STAT: the true pose among others.
struct SimulatorStatus {
  static constexpr std::uint8_t kId = 0x62;
  static constexpr std::uint32_t kHasGlobalPosition = 1U << 1U;
  static constexpr std::uint32_t kHasOdometryError = 1U << 2U;

  std::uint8_t reserved1 = 0;
  std::uint8_t reserved2 = 0;
  std::uint32_t flags = 0;
  std::uint16_t simulatedIntervalMs = 0;
  std::uint16_t realIntervalMs = 0;
  std::uint16_t lastIntervalMs = 0;
  std::int32_t xMm = 0;
  std::int32_t yMm = 0;
  std::int32_t zMm = 0;
  std::int32_t headingDeg = 0;
  std::int32_t latitude1e7 = 0;
  std::int32_t longitude1e7 = 0;
  std::int32_t altitudeCm = 0;
  std::int32_t positionQuality = 0;
  // Shares, times 10^7.
  std::int32_t odometryErrorX1e7 = 0;
  std::int32_t odometryErrorY1e7 = 0;
  std::int32_t odometryErrorHeading1e7 = 0;
  Bytes rest;
  bool operator==(const SimulatorStatus&) const = default;
};

/// The answer to SIM_CTRL 6.
struct SimulatorInfo {
  static constexpr std::uint8_t kId = 0x63;
  struct Device {
    std::string name;
    std::string type;
    std::uint8_t number = 0;
    std::uint32_t status = 0;
    bool operator==(const Device&) const = default;
  };
  std::string application;
  std::string version;
  std::uint32_t flags = 0;
  std::vector<Device> devices;
  Bytes rest;
  bool operator==(const SimulatorInfo&) const = default;
};

/// Tells every client that the simulator's map is another.
struct MapChanged {
  static constexpr std::uint8_t kId = 0x66;
  std::uint8_t byUser = 0;
  std::uint8_t loaded = 0;
  std::string file;
  Bytes rest;
  bool operator==(const MapChanged&) const = default;
};

}  // namespace robotlink::arcos
