// SPDX-License-Identifier: GPL-3.0-or-later
// Units and limits of what a microcontroller reports: no reading leaves the range of its field.
#include "robotlink/arcos/server/ServerTelemetry.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace robotlink::arcos {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr double kInfinite = std::numeric_limits<double>::infinity();
const double kNoNumber = std::nan("");

class ServerTelemetryTest : public testing::Test {
 protected:
  StandardInformation information() const {
    return informationOf(settings_, sensing_, MotionController(settings_.motion),
                         SonarFiring(settings_.sonars), report_);
  }

  ServerSettings settings_;
  RobotSensing sensing_;
  ServerReport report_;
};

TEST_F(ServerTelemetryTest, speedsAreRoundedToMillimetersAndStayInTheirField) {
  sensing_.leftSpeed = -0.2506;
  sensing_.rightSpeed = 1000;
  EXPECT_EQ(information().leftSpeedMmS, -251);
  EXPECT_EQ(information().rightSpeedMmS, 32767);
  sensing_.leftSpeed = kNoNumber;
  sensing_.rightSpeed = -kInfinite;
  EXPECT_EQ(information().leftSpeedMmS, 0);
  EXPECT_EQ(information().rightSpeedMmS, 0);
}

TEST_F(ServerTelemetryTest, theTurningRateIsThatOfTheRimsOnTheEffectiveTrack) {
  settings_.motion.track = 0.5;
  sensing_.leftSpeed = -0.1;
  sensing_.rightSpeed = 0.1;
  // 0.4 rad/s = 22.9 deg/s.
  EXPECT_EQ(information().rotationRateDeciDegS, 229);
}

TEST_F(ServerTelemetryTest, theBatteryHasTwoFieldsOfDifferentRange) {
  report_.battery = 12.34;
  EXPECT_EQ(information().batteryDecivolts, 123);
  EXPECT_EQ(information().batteryDecivolts16, 123);
  report_.battery = 48;
  EXPECT_EQ(information().batteryDecivolts, 255);
  EXPECT_EQ(information().batteryDecivolts16, 480);
  report_.battery = -1;
  EXPECT_EQ(information().batteryDecivolts, 0);
}

TEST_F(ServerTelemetryTest, aVoltageAtWhichItSwitchesItselfOffIsAFault) {
  report_.battery = settings_.shutdownVoltage;
  EXPECT_EQ(information().faultFlags, 0);
  report_.battery = settings_.shutdownVoltage - 0.1;
  EXPECT_EQ(information().faultFlags, StandardInformation::kLowBatteryShutdown);
}

TEST_F(ServerTelemetryTest, anEmptyBatteryIsNotAnUnknownOne) {
  sensing_.charge = 0;
  EXPECT_EQ(information().stateOfChargePercent, 1) << "0 means unknown";
  sensing_.charge = 2;
  EXPECT_EQ(information().stateOfChargePercent, 100);
  EXPECT_EQ(batteryOf(sensing_).batteries.at(0).relativeChargePercent, 100);
  sensing_.charge = 0;
  EXPECT_EQ(batteryOf(sensing_).batteries.at(0).relativeChargePercent, 0);
}

TEST_F(ServerTelemetryTest, onlySegmentsThatTheRobotHasArePressed) {
  sensing_.frontBumpers = 0xFF;
  sensing_.rearBumpers = 0b10;
  settings_.frontBumpers = 3;
  settings_.rearBumpers = 0;
  EXPECT_EQ(information().stallAndBumpers, 0b111U << 9U);
  settings_.rearBumpers = 5;
  EXPECT_EQ(information().stallAndBumpers, (0b111U << 9U) | (0b10U << 1U));
  settings_.frontBumpers = -1;
  EXPECT_EQ(information().stallAndBumpers, 0b10U << 1U);
}

TEST_F(ServerTelemetryTest, bumperInputsAreLowWhilePressed) {
  sensing_.frontBumpers = 0b101;
  EXPECT_THAT(ioOf(settings_, sensing_, report_).digitalIn, ElementsAre(0xFF, 0xF5, 0xFF, 0xFF));
  settings_.frontBumpers = 0;
  EXPECT_EQ(ioOf(settings_, sensing_, report_).digitalIn.at(1), 0xFF);
}

TEST_F(ServerTelemetryTest, theBatteryIsTheLastAnalogInput) {
  report_.battery = 12.8;
  report_.digitalOut = 5;
  const IoPacket io = ioOf(settings_, sensing_, report_);
  EXPECT_THAT(io.analog, ElementsAre(0, 0, 0, 0, 0, 0, 0, 0, 128));
  EXPECT_THAT(io.digitalOut, ElementsAre(5));
}

TEST_F(ServerTelemetryTest, aSonarWithoutAnEchoReadsItsMaximum) {
  settings_.sonarMaximum = 5;
  report_.sonars = {{0, 1.2345}, {3, kInfinite}, {4, kNoNumber}, {7, 20}, {9, -1}};
  std::vector<std::pair<int, int>> sonars;
  for (const auto& sonar : information().sonars) sonars.emplace_back(sonar.number, sonar.rangeMm);
  EXPECT_THAT(sonars, ElementsAre(std::pair(0, 1235), std::pair(3, 5000), std::pair(4, 5000),
                                  std::pair(7, 5000), std::pair(9, 0)));
}

TEST_F(ServerTelemetryTest, theStopButtonIsAFlag) {
  EXPECT_EQ(information().flags & StandardInformation::kEmergencyStop, 0);
  sensing_.stopButton = true;
  EXPECT_NE(information().flags & StandardInformation::kEmergencyStop, 0);
}

TEST_F(ServerTelemetryTest, encodersWrapAroundAsTheirCountersDo) {
  settings_.encoderTicks = 1000;
  sensing_.leftTravel = -1.5;
  sensing_.rightTravel = 2147483.649;  // 2^31 + 1 ticks
  EXPECT_EQ(encodersOf(settings_, sensing_).leftTicks, -1500);
  EXPECT_EQ(encodersOf(settings_, sensing_).rightTicks, std::numeric_limits<std::int32_t>::min() + 1);
  sensing_.leftTravel = kNoNumber;
  EXPECT_EQ(encodersOf(settings_, sensing_).leftTicks, 0);
}

TEST_F(ServerTelemetryTest, aGyroscopeIsInTheMiddleAtRestAndLowerWhenItTurnsLeft) {
  EXPECT_EQ(gyroReadingOf(sensing_).rate, 512);
  sensing_.rotationRate = radians(100.0);
  const int reading = gyroReadingOf(sensing_).rate;
  // As ARIA decodes it for this kind of robot.
  EXPECT_NEAR((512 - reading) * 5.0 / 1023 * 300 / 2.5 * 1.626, 100, 0.5);
  sensing_.rotationRate = 100;
  EXPECT_EQ(gyroReadingOf(sensing_).rate, 0) << "it has ten bits";
  sensing_.rotationRate = -100;
  EXPECT_EQ(gyroReadingOf(sensing_).rate, 1023);
}

TEST_F(ServerTelemetryTest, anInertialUnitMeasuresOneAxisAndItsTemperature) {
  sensing_.rotationRate = radians(-18.32);
  sensing_.temperature = 25 + 14.53;
  const ImuPacket imu = imuOf(sensing_);
  ASSERT_EQ(imu.readings.size(), 1U);
  EXPECT_THAT(imu.readings[0].gyro, ElementsAre(-1000));
  EXPECT_THAT(imu.readings[0].temperature, ElementsAre(100));
  EXPECT_THAT(imu.readings[0].acceleration, IsEmpty());
}

TEST_F(ServerTelemetryTest, theConfigurationHasTheUnitsOfTheWire) {
  MotionParameters motion;
  motion.speed = 0.75;
  motion.rotation = radians(100.0);
  motion.track = 0.5;
  settings_.encoderTicks = 128000;
  settings_.sonars = 8;
  settings_.lowVoltage = 11.5;
  settings_.watchdog = std::chrono::seconds(100);
  const Configuration c = configurationOf(settings_, motion);
  EXPECT_EQ(c.transVelMaxMmS, 750);
  EXPECT_EQ(c.rotVelMaxDegS, 100);
  EXPECT_EQ(c.ticksMm, 128);
  EXPECT_EQ(c.revCount, 25133) << "pi 0.5 m / 2 of 128000 ticks a meter, by 4";
  EXPECT_EQ(c.lowBatteryDecivolts, 115);
  EXPECT_EQ(c.watchdogMs, 65535) << "its field has no room for more";
  EXPECT_EQ(c.frontSonar, 1);
  EXPECT_EQ(c.rearSonar, 0) << "eight sonars are one array";
}

TEST_F(ServerTelemetryTest, aSimulatorNamesOnlyTheDevicesThatItHas) {
  settings_.sonars = 0;
  settings_.laser.reset();
  const SimulatorInfo info = infoOf(settings_);
  ASSERT_EQ(info.devices.size(), 1U);
  EXPECT_EQ(info.devices[0].type, "bumper");
}

}  // namespace
}  // namespace robotlink::arcos
