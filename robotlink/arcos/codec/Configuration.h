// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "robotlink/arcos/codec/Packet.h"

namespace robotlink::arcos {

/// A robot's parameters: CONFIGpac, 0x20, the answer to CONFIG. In the order of the wire.
///
/// Older controllers send only the first fields; the others are 0 then. `...Top` is what the robot can never
/// exceed,
/// `...Max` the limit that counts now.
struct Configuration {
  static constexpr std::uint8_t kId = 0x20;
  static constexpr int kAllFields = 67;
  /// Simulators, and older firmware, end before pdbPort.
  static constexpr int kUsualFields = 57;

  std::string type = "Pioneer";
  std::string subtype;  ///< "p3at-sh"
  std::string serialNumber;
  std::uint8_t fourMotors = 0;
  std::uint16_t rotVelTopDegS = 0;
  std::uint16_t transVelTopMmS = 0;
  std::uint16_t rotAccTopDegS2 = 0;
  std::uint16_t transAccTopMmS2 = 0;
  std::uint16_t pwmMax = 0;
  std::string name;
  std::uint8_t sipCycleMs = 0;
  std::uint8_t hostBaud = 0;
  std::uint8_t auxBaud1 = 0;
  std::uint16_t gripper = 0;
  std::uint16_t frontSonar = 0;
  std::uint8_t rearSonar = 0;
  std::uint16_t lowBatteryDecivolts = 0;
  std::uint16_t revCount = 0;
  std::uint16_t watchdogMs = 0;
  std::uint8_t p2Mpacs = 0;
  std::uint16_t stallValue = 0;
  std::uint16_t stallCountMs = 0;
  std::uint16_t joyVelMmS = 0;
  std::uint16_t joyRotVelDegS = 0;
  std::uint16_t rotVelMaxDegS = 0;
  std::uint16_t transVelMaxMmS = 0;
  std::uint16_t rotAccDegS2 = 0;
  std::uint16_t rotDecelDegS2 = 0;
  std::uint16_t rotKp = 0;
  std::uint16_t rotKv = 0;
  std::uint16_t rotKi = 0;
  std::uint16_t transAccMmS2 = 0;
  std::uint16_t transDecelMmS2 = 0;
  std::uint16_t transKp = 0;
  std::uint16_t transKv = 0;
  std::uint16_t transKi = 0;
  std::uint8_t frontBumpers = 0;
  std::uint8_t rearBumpers = 0;
  std::uint8_t charger = 0;
  std::uint8_t sonarCycleMs = 0;
  std::uint8_t autoBaud = 0;
  std::uint8_t hasGyro = 0;      ///< 0 none, 1 for the client to use, 2 used by the robot
  std::int16_t driftFactor = 0;  ///< of 8192
  std::uint8_t auxBaud2 = 0;
  std::uint8_t auxBaud3 = 0;
  std::uint16_t ticksMm = 0;
  std::uint16_t shutdownDecivolts = 0;
  std::string version;
  std::uint16_t gyroCw = 0;
  std::uint16_t gyroCcw = 0;
  std::uint8_t kinematicsDelayMs = 0;
  std::uint16_t latVelTopMmS = 0;
  std::uint16_t latAccTopMmS2 = 0;
  std::uint16_t latVelMaxMmS = 0;
  std::uint16_t latAccMmS2 = 0;
  std::uint16_t latDecelMmS2 = 0;
  std::uint16_t chargeThreshold = 0;
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

  int fieldCount = kUsualFields;  ///< how many of these the packet has
  Bytes rest;                     ///< behind them

  bool operator==(const Configuration&) const = default;
};

}  // namespace robotlink::arcos
