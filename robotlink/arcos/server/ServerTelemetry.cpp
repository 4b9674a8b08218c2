// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/server/ServerTelemetry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace robotlink::arcos {
namespace {

/// The unit of angles on the wire: 1/4096 of a turn, in rad.
constexpr double kAngleUnit = 2 * kPi / 4096;
/// ARIA: rate (deg/s) = (512 - reading) * 5 V / 1023 * 300 deg/s / 2.5 V * 1.626, the factor of a p3at-sh.
constexpr double kGyroCenter = 512, kGyroUnitDeg = 5.0 / 1023 * 300 / 2.5 * 1.626;
/// An inertial unit's range 3, for 300 deg/s.
constexpr std::uint8_t kImuRange = 3;
constexpr double kImuRateUnitDeg = 0.01832, kImuTemperatureUnit = 0.1453, kImuTemperatureCenter = 25;

/// Clients use a hundredth of it as the dilution of precision; 0 means that the position is bad.
constexpr std::int32_t kGoodPosition = 100;

/// Rounds, and clamps to the range of the field.
template <typename T>
T rounded(double value) {
  if (!std::isfinite(value)) return 0;
  const auto low = static_cast<double>(std::numeric_limits<T>::min());
  const auto high = static_cast<double>(std::numeric_limits<T>::max());
  return static_cast<T>(std::clamp(std::round(value), low, high));
}

/// Rounds, and wraps around at the limits of the field, as an odometry does.
template <typename T>
T wrapped(double value) {
  if (!std::isfinite(value)) return 0;
  const double span = std::ldexp(1.0, 8 * sizeof(T));
  return static_cast<T>(static_cast<std::int64_t>(std::fmod(std::round(value), span)));
}

std::uint16_t mm(double meters) {
  return rounded<std::uint16_t>(meters * 1000);
}
std::uint16_t deg(double angle) {
  return rounded<std::uint16_t>(degrees(angle));
}
std::int16_t angleUnits(double angle) {
  return rounded<std::int16_t>(normalizedAngle(angle) / kAngleUnit);
}

std::uint8_t segments(std::uint8_t pressed, int count) {
  return static_cast<std::uint8_t>(pressed & ((1U << std::clamp(count, 0, 7)) - 1));
}

std::uint16_t stallAndBumpers(const ServerSettings& settings, const RobotSensing& sensing,
                              const MotionController& motion) {
  const unsigned front = segments(sensing.frontBumpers, settings.frontBumpers);
  const unsigned rear = segments(sensing.rearBumpers, settings.rearBumpers);
  unsigned bits = (front << 9U) | (rear << 1U);
  if (motion.leftStalled()) bits |= StandardInformation::kLeftStalled;
  if (motion.rightStalled()) bits |= StandardInformation::kRightStalled;
  return static_cast<std::uint16_t>(bits);
}

std::uint16_t flagsOf(const RobotSensing& sensing, const MotionController& motion,
                      const SonarFiring& sonars) {
  unsigned flags = motion.motorsOn() ? StandardInformation::kMotorsOn : 0U;
  for (int array = 0; array < SonarFiring::kMaxArrays; ++array) {
    if (sonars.isOn(array)) flags |= unsigned{StandardInformation::kSonarArray1On} << array;
  }
  if (sensing.stopButton) flags |= StandardInformation::kEmergencyStop;
  return static_cast<std::uint16_t>(flags);
}

std::vector<StandardInformation::Sonar> sonarsOf(const ServerSettings& settings, const ServerReport& report) {
  std::vector<StandardInformation::Sonar> sonars;
  for (const auto& [number, range] : report.sonars) {
    const double known =
        std::isfinite(range) ? std::clamp(range, 0.0, settings.sonarMaximum) : settings.sonarMaximum;
    sonars.push_back({static_cast<std::uint8_t>(number), mm(known)});
  }
  return sonars;
}

}  // namespace

Identity identityOf(const ServerSettings& settings) {
  return {settings.name, settings.robotClass, settings.subclass, {}};
}

Configuration configurationOf(const ServerSettings& settings, const MotionParameters& now) {
  Configuration c;
  c.type = settings.robotClass;
  c.subtype = settings.subclass;
  c.serialNumber = settings.serialNumber;
  c.fourMotors = 1;
  c.gripper = settings.gripper ? 2 : 0;
  c.rotVelTopDegS = deg(now.rotationTop);
  c.transVelTopMmS = mm(now.speedTop);
  c.rotAccTopDegS2 = deg(now.rotationAccelerationTop);
  c.transAccTopMmS2 = mm(now.accelerationTop);
  c.pwmMax = 500;
  c.name = settings.name;
  c.sipCycleMs = rounded<std::uint8_t>(seconds(settings.cycle) * 1000);
  c.frontSonar = settings.sonars > 0;
  c.rearSonar = settings.sonars > SonarFiring::kDiscsOfArray;
  c.lowBatteryDecivolts = rounded<std::uint16_t>(settings.lowVoltage * 10);
  // Ticks of a half turn, divided by 4; the manufacturer's relation of track and ticks.
  c.revCount = rounded<std::uint16_t>(kPi * now.track * settings.encoderTicks / 8);
  c.watchdogMs = rounded<std::uint16_t>(seconds(settings.watchdog) * 1000);
  c.stallValue = 200;
  c.stallCountMs = rounded<std::uint16_t>(seconds(now.stallPause) * 1000);
  c.joyVelMmS = mm(now.speed);
  c.joyRotVelDegS = deg(now.rotation);
  c.rotVelMaxDegS = deg(now.rotation);
  c.transVelMaxMmS = mm(now.speed);
  c.rotAccDegS2 = deg(now.rotationAcceleration);
  c.rotDecelDegS2 = deg(now.rotationDeceleration);
  c.rotKp = 40, c.rotKv = 20;
  c.transAccMmS2 = mm(now.acceleration);
  c.transDecelMmS2 = mm(now.deceleration);
  c.transKp = 40, c.transKv = 30;
  c.frontBumpers = static_cast<std::uint8_t>(std::clamp(settings.frontBumpers, 0, 7));
  c.rearBumpers = static_cast<std::uint8_t>(std::clamp(settings.rearBumpers, 0, 7));
  c.sonarCycleMs = rounded<std::uint8_t>(seconds(SonarFiring::kPeriod) * 1000);
  c.autoBaud = 2;
  c.hasGyro = static_cast<std::uint8_t>(settings.gyroscope);
  c.ticksMm = rounded<std::uint16_t>(settings.encoderTicks / 1000);
  c.shutdownDecivolts = rounded<std::uint16_t>(settings.shutdownVoltage * 10);
  c.version = settings.firmware;
  return c;
}

StandardInformation informationOf(const ServerSettings& settings, const RobotSensing& sensing,
                                  const MotionController& motion, const SonarFiring& sonars,
                                  const ServerReport& report) {
  StandardInformation sip;
  const Pose2& odometry = motion.odometry();
  sip.moving = settings.reportsMotion && motion.moving();
  sip.xMm = wrapped<std::int16_t>(odometry.x * 1000);
  sip.yMm = wrapped<std::int16_t>(odometry.y * 1000);
  sip.heading4096 = angleUnits(odometry.heading);
  sip.leftSpeedMmS = rounded<std::int16_t>(sensing.leftSpeed * 1000);
  sip.rightSpeedMmS = rounded<std::int16_t>(sensing.rightSpeed * 1000);
  sip.batteryDecivolts = rounded<std::uint8_t>(report.battery * 10);
  sip.stallAndBumpers = stallAndBumpers(settings, sensing, motion);
  sip.headingSetpoint4096 = angleUnits(motion.headingSetpoint());
  sip.flags = flagsOf(sensing, motion, sonars);
  sip.sonars = sonarsOf(settings, report);
  sip.gripState = report.gripper;
  sip.analogPort = std::uint8_t{0};
  sip.analog = std::uint8_t{0};
  sip.digitalIn = std::uint8_t{0xFF};
  sip.digitalOut = report.digitalOut;
  sip.batteryDecivolts16 = rounded<std::uint16_t>(report.battery * 10);
  sip.chargeState = std::uint8_t{0};
  const double turning = (sensing.rightSpeed - sensing.leftSpeed) / settings.motion.track;
  sip.rotationRateDeciDegS = rounded<std::int16_t>(degrees(turning) * 10);
  sip.faultFlags =
      report.battery < settings.shutdownVoltage ? StandardInformation::kLowBatteryShutdown : std::uint16_t{0};
  sip.lateralSpeedMmS = std::int16_t{0};
  sip.temperatureDegC = rounded<std::int8_t>(sensing.temperature);
  sip.stateOfChargePercent = rounded<std::uint8_t>(std::clamp(sensing.charge, 0.01, 1.0) * 100);
  return sip;
}

EncoderPacket encodersOf(const ServerSettings& settings, const RobotSensing& sensing) {
  return {wrapped<std::int32_t>(sensing.leftTravel * settings.encoderTicks),
          wrapped<std::int32_t>(sensing.rightTravel * settings.encoderTicks),
          {}};
}

IoPacket ioOf(const ServerSettings& settings, const RobotSensing& sensing, const ServerReport& report) {
  IoPacket io;
  // Bumper inputs are high, and low while pressed; there are no infrared sensors.
  const auto raw = [](unsigned pressed) { return static_cast<std::uint8_t>(~(pressed << 1U)); };
  io.digitalIn = {0xFF, raw(segments(sensing.frontBumpers, settings.frontBumpers)),
                  raw(segments(sensing.rearBumpers, settings.rearBumpers)), 0xFF};
  io.digitalOut = {report.digitalOut};
  io.analog.assign(8, 0);
  io.analog.push_back(rounded<std::uint16_t>(report.battery * 10));
  return io;
}

GyroPacket::Reading gyroReadingOf(const RobotSensing& sensing) {
  const double reading = kGyroCenter - degrees(sensing.rotationRate) / kGyroUnitDeg;
  return {static_cast<std::uint16_t>(std::clamp<int>(rounded<std::int16_t>(reading), 0, 1023)),
          rounded<std::uint8_t>(sensing.temperature)};
}

ImuPacket imuOf(const RobotSensing& sensing) {
  ImuPacket::Reading reading;
  reading.gyroRange = kImuRange;
  reading.gyro = {rounded<std::int16_t>(degrees(sensing.rotationRate) / kImuRateUnitDeg)};
  reading.temperature = {
      rounded<std::int16_t>((sensing.temperature - kImuTemperatureCenter) / kImuTemperatureUnit)};
  ImuPacket imu;
  imu.readings = {reading};
  return imu;
}

BatteryPacket batteryOf(const RobotSensing& sensing) {
  const auto percent = rounded<std::uint8_t>(std::clamp(sensing.charge, 0.0, 1.0) * 100);
  BatteryPacket battery;
  battery.batteries.push_back({0, 0, 0, percent, percent, {}});
  return battery;
}

SimulatorStatus statusOf(const ServerSettings& settings, const RobotSensing& sensing) {
  SimulatorStatus status;
  const auto interval = rounded<std::uint16_t>(seconds(settings.cycle) * 1000);
  status.simulatedIntervalMs = status.realIntervalMs = status.lastIntervalMs = interval;
  status.xMm = rounded<std::int32_t>(sensing.truePose.x * 1000);
  status.yMm = rounded<std::int32_t>(sensing.truePose.y * 1000);
  status.zMm = rounded<std::int32_t>(sensing.trueHeight * 1000);
  status.headingDeg = rounded<std::int32_t>(degrees(sensing.truePose.heading));
  if (sensing.globalPosition) {
    status.flags |= SimulatorStatus::kHasGlobalPosition;
    status.latitude1e7 = rounded<std::int32_t>(sensing.globalPosition->latitude * 1e7);
    status.longitude1e7 = rounded<std::int32_t>(sensing.globalPosition->longitude * 1e7);
    status.altitudeCm = rounded<std::int32_t>(sensing.globalPosition->altitude * 100);
    status.positionQuality = kGoodPosition;
  }
  if (sensing.odometryError != 0) {
    status.flags |= SimulatorStatus::kHasOdometryError;
    status.odometryErrorX1e7 = status.odometryErrorHeading1e7 =
        rounded<std::int32_t>(sensing.odometryError * 1e7);
  }
  return status;
}

SimulatorInfo infoOf(const ServerSettings& settings) {
  SimulatorInfo info;
  info.application = settings.application;
  info.version = settings.applicationVersion;
  if (settings.sonars > 0) info.devices.push_back({"sonar", "sonar", 1, 0});
  if (settings.laser) info.devices.push_back({"laser", "laser", 1, 0});
  info.devices.push_back({"bumpers", "bumper", 1, 0});
  return info;
}

}  // namespace robotlink::arcos
