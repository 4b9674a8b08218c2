// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include "robotlink/arcos/codec/ServerPackets.h"
#include "robotlink/arcos/server/MotionController.h"
#include "robotlink/arcos/server/RobotSensing.h"
#include "robotlink/arcos/server/ServerSettings.h"
#include "robotlink/arcos/server/SonarFiring.h"

// What a robot's microcontroller says of itself, as the packets of the wire: from SI units and radians to
// those of a p3at-sh. Pure functions; only this folder's sources and tests include this.
namespace robotlink::arcos {

/// What information packets tell of the server's own state.
struct ServerReport {
  std::map<int, double> sonars;  ///< m, by number: those measured since the last packet
  double battery = 0;            ///< V
  std::uint8_t digitalOut = 0;
};

Identity identityOf(const ServerSettings& settings);
/// The parameters as they are now, the tops and what never changes.
Configuration configurationOf(const ServerSettings& settings, const MotionParameters& now);
StandardInformation informationOf(const ServerSettings& settings, const RobotSensing& sensing,
                                  const MotionController& motion, const SonarFiring& sonars,
                                  const ServerReport& report);
EncoderPacket encodersOf(const ServerSettings& settings, const RobotSensing& sensing);
IoPacket ioOf(const ServerSettings& settings, const RobotSensing& sensing, const ServerReport& report);
/// One reading of a gyroscope as ARIA understands it with a p3at-sh's factors.
GyroPacket::Reading gyroReadingOf(const RobotSensing& sensing);
ImuPacket imuOf(const RobotSensing& sensing);
BatteryPacket batteryOf(const RobotSensing& sensing);
SimulatorStatus statusOf(const ServerSettings& settings, const RobotSensing& sensing);
SimulatorInfo infoOf(const ServerSettings& settings);

}  // namespace robotlink::arcos
