// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "robotlink/arcos/codec/Packet.h"

namespace robotlink::arcos {

/// A robot's parameters: packet CONFIGpac, the reply to CONFIG (Pioneer 3 Operations Manual). Fields are in
/// the order of the wire.
///
/// Older controllers send only the first fields; the others are 0. `...Top` is a limit that can never be
/// exceeded, `...Max` the present limit. Units are part of the names; fields without one are counts, flags or
/// codes.
struct Configuration {
  static constexpr std::uint8_t kId = 0x20;
  /// The number of fields that are known here.
  static constexpr int kAllFields = 67;
  /// The number of fields of simulators and older firmware, which end before pdbPort.
  static constexpr int kUsualFields = 57;

  // Identity.
  std::string type = "Pioneer";
  /// The subclass: "p3at-sh".
  std::string subtype;
  std::string serialNumber;
  /// 1 for robots with four motors (P3-AT).
  std::uint8_t fourMotors = 0;
  // Limits that can never be exceeded.
  std::uint16_t rotVelTopDegS = 0;
  std::uint16_t transVelTopMmS = 0;
  std::uint16_t rotAccTopDegS2 = 0;
  std::uint16_t transAccTopMmS2 = 0;
  /// Maximum duty cycle of the motors' pulse width modulation.
  std::uint16_t pwmMax = 0;
  /// The name given by the robot's owner.
  std::string name;
  /// Interval of the information packets.
  std::uint8_t sipCycleMs = 0;
  /// Codes of the baud rates: 0 is 9600, 1 19200, 2 38400, 3 57600, 4 115200.
  std::uint8_t hostBaud = 0;
  std::uint8_t auxBaud1 = 0;
  /// Type of the gripper; 0 if there is none.
  std::uint16_t gripper = 0;
  /// 1 if there is a front or a rear array of sonars, otherwise 0.
  std::uint16_t frontSonar = 0;
  std::uint8_t rearSonar = 0;
  /// Voltage below which the battery counts as low.
  std::uint16_t lowBatteryDecivolts = 0;
  /// Encoder ticks of a half turn, divided by 4.
  std::uint16_t revCount = 0;
  /// Silence of the client before the robot stops.
  std::uint16_t watchdogMs = 0;
  /// Alternative information packets of older robots.
  std::uint8_t p2Mpacs = 0;
  /// Motor load that counts as a stall, and the pause of the motors after one.
  std::uint16_t stallValue = 0;
  std::uint16_t stallCountMs = 0;
  /// Limits of the joystick.
  std::uint16_t joyVelMmS = 0;
  std::uint16_t joyRotVelDegS = 0;
  // Present limits and accelerations.
  std::uint16_t rotVelMaxDegS = 0;
  std::uint16_t transVelMaxMmS = 0;
  std::uint16_t rotAccDegS2 = 0;
  std::uint16_t rotDecelDegS2 = 0;
  // Gains of the rotation controller: proportional, differential, integral.
  std::uint16_t rotKp = 0;
  std::uint16_t rotKv = 0;
  std::uint16_t rotKi = 0;
  std::uint16_t transAccMmS2 = 0;
  std::uint16_t transDecelMmS2 = 0;
  // Gains of the translation controller.
  std::uint16_t transKp = 0;
  std::uint16_t transKv = 0;
  std::uint16_t transKi = 0;
  /// Numbers of bumper segments.
  std::uint8_t frontBumpers = 0;
  std::uint8_t rearBumpers = 0;
  /// Type of the charger; 0 if there is none.
  std::uint8_t charger = 0;
  /// Time between two sonars of an array.
  std::uint8_t sonarCycleMs = 0;
  /// Whether the controller adapts to the client's baud rate.
  std::uint8_t autoBaud = 0;
  /// 0: none; 1: for the client to use; 2: used by the robot itself.
  std::uint8_t hasGyro = 0;
  /// Difference of the wheels' sizes, in 1/8192.
  std::int16_t driftFactor = 0;
  std::uint8_t auxBaud2 = 0;
  std::uint8_t auxBaud3 = 0;
  /// Encoder ticks per mm.
  std::uint16_t ticksMm = 0;
  /// Voltage at which the robot switches itself off.
  std::uint16_t shutdownDecivolts = 0;
  /// Version of the firmware.
  std::string version;
  /// Calibration of the gyroscope, clockwise and counterclockwise.
  std::uint16_t gyroCw = 0;
  std::uint16_t gyroCcw = 0;
  std::uint8_t kinematicsDelayMs = 0;
  // Robots that can drive sideways: limits and accelerations.
  std::uint16_t latVelTopMmS = 0;
  std::uint16_t latAccTopMmS2 = 0;
  std::uint16_t latVelMaxMmS = 0;
  std::uint16_t latAccMmS2 = 0;
  std::uint16_t latDecelMmS2 = 0;
  std::uint16_t chargeThreshold = 0;
  // The following fields are sent only by newer firmware.
  std::uint8_t pdbPort = 0;
  std::uint16_t gyroRateLimitDegS = 0;
  std::int8_t highTemperatureDegC = 0;
  std::uint16_t powerBits = 0;
  std::uint8_t batteryType = 0;
  std::uint16_t stateOfChargeLow = 0;
  std::uint16_t stateOfChargeShutdown = 0;
  std::string bootVersion;
  std::uint32_t configFlags = 0;
  std::int16_t gyroFirmwareVersion = 0;

  /// How many of these fields the packet has.
  int fieldCount = kUsualFields;
  /// Data after the known fields.
  Bytes rest;

  bool operator==(const Configuration&) const = default;
};

}  // namespace robotlink::arcos
