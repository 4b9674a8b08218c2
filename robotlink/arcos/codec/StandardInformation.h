// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "robotlink/arcos/codec/Packet.h"
#include "robotlink/base/Error.h"

namespace robotlink::arcos {

/// The state that a robot sends every 100 ms: the standard information packet (SIP), id 0x32 while it stands
/// and 0x33 while it moves (Pioneer 3 Operations Manual).
///
/// Lengths, speeds and angles must be multiplied by factors of the robot's type; the names here are those of
/// a p3at-sh (1 mm, 1 mm/s, 1/4096 of a turn). The odometry wraps at 16 bits. StateDecoder converts it to SI
/// units.
struct StandardInformation {
  /// A sonar's latest range.
  struct Sonar {
    /// The number of the sonar, from 0.
    std::uint8_t number = 0;
    std::uint16_t rangeMm = 0;
    bool operator==(const Sonar&) const = default;
  };

  static constexpr std::uint8_t kStandingId = 0x32;
  static constexpr std::uint8_t kMovingId = 0x33;
  static constexpr std::uint8_t kIds[] = {kStandingId, kMovingId};

  // Bits of stallAndBumpers; bumper segment i of a side is bit i + 1 of its byte.
  static constexpr std::uint16_t kLeftStalled = 1U << 0U;
  static constexpr std::uint16_t kRightStalled = 1U << 8U;
  // Bits of flags.
  static constexpr std::uint16_t kMotorsOn = 1U << 0U;
  /// For array n, up to 4, shifted left by n - 1.
  static constexpr std::uint16_t kSonarArray1On = 1U << 1U;
  static constexpr std::uint16_t kAnySonarOn = 0xFU << 1U;
  static constexpr std::uint16_t kEmergencyStop = 1U << 5U;
  static constexpr std::uint16_t kEmergencyStall = 1U << 6U;
  static constexpr std::uint16_t kFarInfrared = 1U << 7U;
  static constexpr std::uint16_t kNearInfrared = 1U << 8U;
  static constexpr std::uint16_t kJoystickButton = 1U << 9U;
  static constexpr std::uint16_t kChargerPower = 1U << 10U;
  // Bits of faultFlags.
  static constexpr std::uint16_t kTemperatureFault = 1U << 1U;
  static constexpr std::uint16_t kLowBatteryShutdown = 1U << 3U;
  static constexpr std::uint16_t kGyroFault = 1U << 4U;
  /// Temperatures up to this value mean that it is unknown.
  static constexpr std::int8_t kNoTemperature = -127;

  /// Whether the robot moves, from the packet's id.
  bool moving = false;
  // Pose by odometry.
  std::int16_t xMm = 0;
  std::int16_t yMm = 0;
  /// 4096 per turn, counterclockwise.
  std::int16_t heading4096 = 0;
  std::int16_t leftSpeedMmS = 0;
  std::int16_t rightSpeedMmS = 0;
  std::uint8_t batteryDecivolts = 0;
  /// Low byte: left stall, rear bumpers; high byte: right stall, front bumpers.
  std::uint16_t stallAndBumpers = 0;
  /// The goal of the current turn.
  std::int16_t headingSetpoint4096 = 0;
  std::uint16_t flags = 0;
  /// The compass's heading in units of 2 degrees.
  std::uint8_t compass2Deg = 0;
  /// On a real robot those measured since the last packet.
  std::vector<Sonar> sonars;

  // Older robots' packets end somewhere below: all fields after an empty one are empty.
  std::optional<std::uint8_t> gripState;
  std::optional<std::uint8_t> analogPort;
  /// 255 is 5 V.
  std::optional<std::uint8_t> analog;
  std::optional<std::uint8_t> digitalIn;
  std::optional<std::uint8_t> digitalOut;
  std::optional<std::uint16_t> batteryDecivolts16;
  /// 0: not charging, 1: bulk, 2: over, 3: float, 4: balance, 255: unknown.
  std::optional<std::uint8_t> chargeState;
  /// Measured by a gyroscope.
  std::optional<std::int16_t> rotationRateDeciDegS;
  std::optional<std::uint16_t> faultFlags;
  std::optional<std::int16_t> lateralSpeedMmS;
  std::optional<std::int8_t> temperatureDegC;
  /// 0 means unknown.
  std::optional<std::uint8_t> stateOfChargePercent;
  /// Time since the controller started.
  std::optional<std::uint32_t> controllerTimeUs;
  std::optional<std::uint32_t> moreFlags;
  /// Data after the known fields.
  Bytes rest;

  bool leftStalled() const { return stallAndBumpers & kLeftStalled; }
  bool rightStalled() const { return stallAndBumpers & kRightStalled; }
  /// Bit i: segment i is pressed.
  unsigned frontBumpers() const { return static_cast<unsigned>(stallAndBumpers) >> 9U; }
  unsigned rearBumpers() const { return (stallAndBumpers & 0xFEU) >> 1U; }
  bool motorsOn() const { return flags & kMotorsOn; }
  bool sonarOn() const { return flags & kAnySonarOn; }
  /// The finer of the two voltages, if the packet has both.
  int batteryDecivoltsBest() const { return batteryDecivolts16.value_or(batteryDecivolts); }

  bool operator==(const StandardInformation&) const = default;
};

}  // namespace robotlink::arcos
