// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "robotlink/arcos/codec/Packet.h"
#include "robotlink/base/Error.h"

namespace robotlink::arcos {

/// What a robot says of itself every 100 ms: the standard information packet (SIP), 0x32 while it stands and
/// 0x33 while it moves.
///
/// Lengths, speeds and angles are to be multiplied by factors of the robot's type; they are those of a
/// p3at-sh here (1 mm, 1 mm/s, 1/4096 of a turn). The odometry wraps at 16 bits.
struct StandardInformation {
  struct Sonar {
    std::uint8_t number = 0;  ///< from 0
    std::uint16_t rangeMm = 0;
    bool operator==(const Sonar&) const = default;
  };

  static constexpr std::uint8_t kStandingId = 0x32;
  static constexpr std::uint8_t kMovingId = 0x33;

  // Bits of stallAndBumpers; bumper segment i of a side is its bit i + 1.
  static constexpr std::uint16_t kLeftStalled = 1U << 0U;
  static constexpr std::uint16_t kRightStalled = 1U << 8U;
  // Bits of flags.
  static constexpr std::uint16_t kMotorsOn = 1U << 0U;
  static constexpr std::uint16_t kSonarArray1On = 1U << 1U;  ///< of array n: shifted left by n - 1, up to 4
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
  static constexpr std::int8_t kNoTemperature = -127;

  bool moving = false;
  std::int16_t xMm = 0;
  std::int16_t yMm = 0;
  std::int16_t heading4096 = 0;  ///< 4096 a turn, counter-clockwise
  std::int16_t leftSpeedMmS = 0;
  std::int16_t rightSpeedMmS = 0;
  std::uint8_t batteryDecivolts = 0;
  std::uint16_t stallAndBumpers =
      0;  ///< low byte: left stall, rear bumpers; high byte: right stall, front bumpers
  std::int16_t headingSetpoint4096 = 0;
  std::uint16_t flags = 0;
  std::uint8_t compass2Deg = 0;
  std::vector<Sonar> sonars;  ///< on a real robot those measured since the last packet

  // Older robots' packets end somewhere here: what follows an empty one is empty.
  std::optional<std::uint8_t> gripState;
  std::optional<std::uint8_t> analogPort;
  std::optional<std::uint8_t> analog;  ///< 255 is 5 V
  std::optional<std::uint8_t> digitalIn;
  std::optional<std::uint8_t> digitalOut;
  std::optional<std::uint16_t> batteryDecivolts16;
  std::optional<std::uint8_t> chargeState;  ///< 0 not, 1 bulk, 2 over, 3 float, 4 balance, 255 unknown
  std::optional<std::int16_t> rotationRateDeciDegS;
  std::optional<std::uint16_t> faultFlags;
  std::optional<std::int16_t> lateralSpeedMmS;
  std::optional<std::int8_t> temperatureDegC;
  std::optional<std::uint8_t> stateOfChargePercent;  ///< 0: unknown
  std::optional<std::uint32_t> controllerTimeUs;
  std::optional<std::uint32_t> moreFlags;
  Bytes rest;  ///< behind all that is known

  bool leftStalled() const { return stallAndBumpers & kLeftStalled; }
  bool rightStalled() const { return stallAndBumpers & kRightStalled; }
  /// Bit i: segment i is pressed.
  unsigned frontBumpers() const { return static_cast<unsigned>(stallAndBumpers) >> 9U; }
  unsigned rearBumpers() const { return (stallAndBumpers & 0xFEU) >> 1U; }
  bool motorsOn() const { return flags & kMotorsOn; }
  bool sonarOn() const { return flags & kAnySonarOn; }
  /// The finer of the two voltages.
  int batteryDecivoltsBest() const { return batteryDecivolts16.value_or(batteryDecivolts); }

  bool operator==(const StandardInformation&) const = default;
};

Packet toPacket(const StandardInformation& information);
Result<StandardInformation> decodeStandardInformation(const Packet& packet);

}  // namespace robotlink::arcos
