// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "robotlink/arcos/codec/Packet.h"

// What a robot sends on request beside its standard information. `rest` is always what stands behind all that
// is known.
namespace robotlink::arcos {

/// ENCODERpac: ticks since the robot was turned on.
struct EncoderPacket {
  static constexpr std::uint8_t kId = 0x90;
  std::int32_t leftTicks = 0;
  std::int32_t rightTicks = 0;
  Bytes rest;
  bool operator==(const EncoderPacket&) const = default;
};

/// IOpac. A P3-AT has four bytes of inputs (digital, front bumpers, rear bumpers, infrared), one of outputs
/// and nine analog ports, the last of them its battery. Bumpers are raw here: 0 is pressed.
struct IoPacket {
  static constexpr std::uint8_t kId = 0xF0;
  std::vector<std::uint8_t> digitalIn;
  std::vector<std::uint8_t> digitalOut;
  std::vector<std::uint16_t> analog;  ///< 1023 is 5 V
  Bytes rest;
  bool operator==(const IoPacket&) const = default;
};

/// GYROpac: what a gyroscope measured since the last one, 25 ms apart.
struct GyroPacket {
  static constexpr std::uint8_t kId = 0x98;
  struct Reading {
    std::uint16_t rate = 0;  ///< 10 bits, about 512 at rest, less when turning counter-clockwise
    std::uint8_t temperature = 0;
    bool operator==(const Reading&) const = default;
  };
  std::vector<Reading> readings;
  Bytes rest;
  bool operator==(const GyroPacket&) const = default;
};

/// IMUpac.
struct ImuPacket {
  static constexpr std::uint8_t kId = 0x9A;
  struct Reading {
    std::uint8_t gyroRange = 0;              ///< 1: 75 to 80 deg/s, 2: 150 to 160, 3: 300 to 320
    std::vector<std::int16_t> gyro;          ///< one axis or three
    std::vector<std::int16_t> acceleration;  ///< none or three; 0.002522 g
    std::vector<std::int16_t> temperature;   ///< 0.1453 degC from 25
    bool operator==(const Reading&) const = default;
  };
  std::uint8_t sinceInformationMs = 0;
  std::vector<Reading> readings;
  Bytes rest;
  bool operator==(const ImuPacket&) const = default;
};

/// SERAUXpac: bytes from a serial port of the robot.
struct AuxSerialPacket {
  static constexpr std::uint8_t kIds[] = {0xB0, 0xB8, 0xC8};
  int port = 1;  ///< 1 to 3
  Bytes bytes;
  bool operator==(const AuxSerialPacket&) const = default;
};

/// TCM2pac: a compass that the robot has.
struct CompassPacket {
  static constexpr std::uint8_t kId = 0xC0;
  std::int16_t headingDecidegrees = 0;
  std::int16_t pitchDecidegrees = 0;
  std::int16_t rollDecidegrees = 0;
  std::array<std::int16_t, 3> magneticHundredthsUt = {};  ///< x, y, z
  std::int16_t temperatureDecidegC = 0;
  std::uint16_t error = 0;  ///< the compass's own bits
  // How well it was calibrated, as the compass counts it.
  std::uint8_t horizontalScore = 0;
  std::uint8_t verticalScore = 0;
  std::int16_t magneticScoreHundredths = 0;
  Bytes rest;
  bool operator==(const CompassPacket&) const = default;
};

/// GRIPPERpac.
struct GripperPacket {
  static constexpr std::uint8_t kId = 0xE0;
  std::uint8_t hasGripper = 0;
  std::uint8_t state = 0;
  std::uint8_t graspTime = 0;
  Bytes rest;
  bool operator==(const GripperPacket&) const = default;
};

/// JOYSTICKpac.
struct JoystickPacket {
  static constexpr std::uint8_t kId = 0xF8;
  std::uint8_t button1 = 0;
  std::uint8_t button2 = 0;
  std::int16_t x = 0;
  std::int16_t y = 0;
  std::int16_t throttle = 0;
  Bytes rest;
  bool operator==(const JoystickPacket&) const = default;
};

/// BATTERYpac.
struct BatteryPacket {
  static constexpr std::uint8_t kId = 0xFA;
  static constexpr std::uint8_t kKnownBytes = 5;
  struct Battery {
    std::uint8_t flags1 = 0;
    std::uint8_t flags2 = 0;
    std::uint8_t flags3 = 0;
    std::uint8_t relativeChargePercent = 0;
    std::uint8_t absoluteChargePercent = 0;
    Bytes more;  ///< bytesPerBattery - kKnownBytes
    bool operator==(const Battery&) const = default;
  };
  std::uint8_t bytesPerBattery = kKnownBytes;
  std::vector<Battery> batteries;
  Bytes rest;
  bool operator==(const BatteryPacket&) const = default;
};

}  // namespace robotlink::arcos
