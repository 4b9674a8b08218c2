// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include "robotlink/arcos/codec/ServerPackets.h"
#include "robotlink/arcos/server/MotionController.h"
#include "robotlink/arcos/server/RobotSensing.h"
#include "robotlink/arcos/server/ServerSettings.h"
#include "robotlink/arcos/server/SonarFiring.h"

// The state of a robot's microcontroller as packets: converts SI units and radians to the units of a p3at-sh.
// Pure functions; internal to this folder and its tests.
namespace robotlink::arcos {

/// Values for information packets that are neither sensor readings nor motion.
struct ServerReport {
  /// Ranges measured since the last packet, m, by sonar.
  std::map<int, double> sonars;
  /// Volts.
  double battery = 0;
  std::uint8_t digitalOut = 0;
  /// GripperControl::state().
  std::uint8_t gripper = 0;
};

/// The reply to SYNC2.
Identity identityOf(const ServerSettings& settings);
/// The current parameters together with the constant ones.
Configuration configurationOf(const ServerSettings& settings, const MotionParameters& now);
/// The information packet of a cycle.
StandardInformation informationOf(const ServerSettings& settings, const RobotSensing& sensing,
                                  const MotionController& motion, const SonarFiring& sonars,
                                  const ServerReport& report);
EncoderPacket encodersOf(const ServerSettings& settings, const RobotSensing& sensing);
IoPacket ioOf(const ServerSettings& settings, const RobotSensing& sensing, const ServerReport& report);
/// A reading of the gyroscope, scaled so that ARIA decodes it with the factors of a p3at-sh.
GyroPacket::Reading gyroReadingOf(const RobotSensing& sensing);
/// Returns a reading of an inertial measurement unit: only the rotation rate and the temperature vary.
ImuPacket imuOf(const RobotSensing& sensing);
BatteryPacket batteryOf(const RobotSensing& sensing);
/// The reply to SIM_STAT: the true pose and, if known, global position and odometry error.
SimulatorStatus statusOf(const ServerSettings& settings, const RobotSensing& sensing);
/// The reply to SIM_CTRL 6.
SimulatorInfo infoOf(const ServerSettings& settings);

}  // namespace robotlink::arcos
