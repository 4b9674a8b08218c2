// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "robotlink/arcos/codec/Packet.h"

// Packets that a robot sends on request, besides its standard information (Pioneer 3 Operations Manual).
// Values are in units of the wire. `rest` holds the data after the known fields.
namespace robotlink::arcos {

/// ENCODERpac: encoder ticks since the robot was switched on.
struct EncoderPacket {
  static constexpr std::uint8_t kId = 0x90;
  std::int32_t leftTicks = 0;
  std::int32_t rightTicks = 0;
  Bytes rest;
  bool operator==(const EncoderPacket&) const = default;
};

/// IOpac: digital and analog ports. A P3-AT has four bytes of inputs (digital, front bumpers, rear bumpers,
/// infrared), one of outputs and nine analog ports, the last of which is the battery. Bumper bits are
/// inverted: 0 is pressed.
struct IoPacket {
  static constexpr std::uint8_t kId = 0xF0;
  std::vector<std::uint8_t> digitalIn;
  std::vector<std::uint8_t> digitalOut;
  /// 10 bits: 1023 is 5 V.
  std::vector<std::uint16_t> analog;
  Bytes rest;
  bool operator==(const IoPacket&) const = default;
};

/// GYROpac: readings of the gyroscope since the last packet, 25 ms apart.
struct GyroPacket {
  static constexpr std::uint8_t kId = 0x98;
  struct Reading {
    /// 10 bits, about 512 at rest, less when turning counterclockwise.
    std::uint16_t rate = 0;
    /// In units of the sensor.
    std::uint8_t temperature = 0;
    bool operator==(const Reading&) const = default;
  };
  std::vector<Reading> readings;
  Bytes rest;
  bool operator==(const GyroPacket&) const = default;
};

/// IMUpac: readings of an inertial measurement unit.
struct ImuPacket {
  static constexpr std::uint8_t kId = 0x9A;
  struct Reading {
    /// Code of the range: 1 is 75 to 80 deg/s, 2 150 to 160, 3 300 to 320.
    std::uint8_t gyroRange = 0;
    /// The rotation rates of one or three axes, in units of the sensor.
    std::vector<std::int16_t> gyro;
    /// None or three axes, in 0.002522 g.
    std::vector<std::int16_t> acceleration;
    /// In 0.1453 degC, relative to 25 degC.
    std::vector<std::int16_t> temperature;
    bool operator==(const Reading&) const = default;
  };
  /// Time since the last information packet.
  std::uint8_t sinceInformationMs = 0;
  std::vector<Reading> readings;
  Bytes rest;
  bool operator==(const ImuPacket&) const = default;
};

/// SERAUXpac: bytes from one of the robot's serial ports.
struct AuxSerialPacket {
  /// The packet ids of the ports.
  static constexpr std::uint8_t kIds[] = {0xB0, 0xB8, 0xC8};
  /// In 1 to 3.
  int port = 1;
  Bytes bytes;
  bool operator==(const AuxSerialPacket&) const = default;
};

/// TCM2pac: readings of a compass.
struct CompassPacket {
  static constexpr std::uint8_t kId = 0xC0;
  std::int16_t headingDecidegrees = 0;
  std::int16_t pitchDecidegrees = 0;
  std::int16_t rollDecidegrees = 0;
  /// x, y, z, in 0.01 uT.
  std::array<std::int16_t, 3> magneticHundredthsUt = {};
  std::int16_t temperatureDecidegC = 0;
  /// Error bits of the compass.
  std::uint16_t error = 0;
  // Quality of the last calibration, in units of the compass.
  std::uint8_t horizontalScore = 0;
  std::uint8_t verticalScore = 0;
  std::int16_t magneticScoreHundredths = 0;
  Bytes rest;
  bool operator==(const CompassPacket&) const = default;
};

/// GRIPPERpac: state of the gripper.
struct GripperPacket {
  static constexpr std::uint8_t kId = 0xE0;
  /// Type of the gripper; 0 if there is none.
  std::uint8_t hasGripper = 0;
  /// Bits of the gripper's state.
  std::uint8_t state = 0;
  /// Grasp time, in units of the gripper.
  std::uint8_t graspTime = 0;
  Bytes rest;
  bool operator==(const GripperPacket&) const = default;
};

/// JOYSTICKpac: state of the joystick.
struct JoystickPacket {
  static constexpr std::uint8_t kId = 0xF8;
  std::uint8_t button1 = 0;
  std::uint8_t button2 = 0;
  // In units of the joystick.
  std::int16_t x = 0;
  std::int16_t y = 0;
  std::int16_t throttle = 0;
  Bytes rest;
  bool operator==(const JoystickPacket&) const = default;
};

/// BATTERYpac: state of the batteries.
struct BatteryPacket {
  static constexpr std::uint8_t kId = 0xFA;
  /// The bytes of a battery that have names here.
  static constexpr std::uint8_t kKnownBytes = 5;
  struct Battery {
    /// Bits defined by the battery's type.
    std::uint8_t flags1 = 0;
    std::uint8_t flags2 = 0;
    std::uint8_t flags3 = 0;
    std::uint8_t relativeChargePercent = 0;
    std::uint8_t absoluteChargePercent = 0;
    /// Further data: bytesPerBattery - kKnownBytes bytes.
    Bytes more;
    bool operator==(const Battery&) const = default;
  };
  std::uint8_t bytesPerBattery = kKnownBytes;
  std::vector<Battery> batteries;
  Bytes rest;
  bool operator==(const BatteryPacket&) const = default;
};

}  // namespace robotlink::arcos
