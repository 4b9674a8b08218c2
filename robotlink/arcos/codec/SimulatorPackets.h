// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "robotlink/arcos/codec/Packet.h"

// Packets that only simulators send, as defined by MobileSim. `rest` holds the data after the known fields.
namespace robotlink::arcos {

/// The reply to SIM_STAT: the true pose, and optionally global position and odometry error.
struct SimulatorStatus {
  static constexpr std::uint8_t kId = 0x62;
  // Bits of flags.
  static constexpr std::uint32_t kHasGlobalPosition = 1U << 1U;
  static constexpr std::uint32_t kHasOdometryError = 1U << 2U;

  // Unused.
  std::uint8_t reserved1 = 0;
  std::uint8_t reserved2 = 0;
  std::uint32_t flags = 0;
  // Simulated and real duration of the last steps.
  std::uint16_t simulatedIntervalMs = 0;
  std::uint16_t realIntervalMs = 0;
  std::uint16_t lastIntervalMs = 0;
  // True pose.
  std::int32_t xMm = 0;
  std::int32_t yMm = 0;
  std::int32_t zMm = 0;
  std::int32_t headingDeg = 0;
  // Position on Earth, if kHasGlobalPosition.
  std::int32_t latitude1e7 = 0;
  std::int32_t longitude1e7 = 0;
  std::int32_t altitudeCm = 0;
  /// Clients use a hundredth of it as the dilution of precision; 0 means bad.
  std::int32_t positionQuality = 0;
  // Relative errors of the odometry, times 10^7, if kHasOdometryError.
  std::int32_t odometryErrorX1e7 = 0;
  std::int32_t odometryErrorY1e7 = 0;
  std::int32_t odometryErrorHeading1e7 = 0;
  Bytes rest;
  bool operator==(const SimulatorStatus&) const = default;
};

/// The reply to SIM_CTRL 6: the simulator and the robot's devices.
struct SimulatorInfo {
  static constexpr std::uint8_t kId = 0x63;
  /// A simulated device, such as the laser.
  struct Device {
    std::string name;
    std::string type;
    std::uint8_t number = 0;
    std::uint32_t status = 0;
    bool operator==(const Device&) const = default;
  };
  /// Name and version of the simulator.
  std::string application;
  std::string version;
  std::uint32_t flags = 0;
  std::vector<Device> devices;
  Bytes rest;
  bool operator==(const SimulatorInfo&) const = default;
};

/// Sent to every client when the simulator has loaded another map, or failed to.
struct MapChanged {
  static constexpr std::uint8_t kId = 0x66;
  /// Whether the user rather than a client requested it.
  std::uint8_t byUser = 0;
  /// Whether loading succeeded.
  std::uint8_t loaded = 0;
  std::string file;
  Bytes rest;
  bool operator==(const MapChanged&) const = default;
};

}  // namespace robotlink::arcos
