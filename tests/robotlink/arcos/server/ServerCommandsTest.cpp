// SPDX-License-Identifier: GPL-3.0-or-later
// What a robot does when it is commanded, as seen in its packets.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <set>

#include "tests/robotlink/arcos/IdealRobot.h"

namespace {

using namespace robotlink;
using namespace robotlink::arcos;
using testing::Each;
using testing::IsEmpty;
using testing::SizeIs;
using Sip = StandardInformation;

class ServerCommandsTest : public testing::Test {
 protected:
  IdealRobot robot;

  ServerCommandsTest() {
    robot.connect();
    robot.send(CommandId::kEnable, 1);
  }
  Sip latest() const { return robot.information().back(); }
  double headingDeg() const { return latest().heading4096 * 360.0 / 4096; }
};

TEST_F(ServerCommandsTest, signsAreThoseOfTheWire) {
  robot.send(CommandId::kVel, -250);
  robot.drive(3);
  EXPECT_EQ(latest().leftSpeedMmS, -250);
  EXPECT_LT(latest().xMm, -300);
  robot.send(CommandId::kVel, 0);
  robot.send(CommandId::kRvel, -10);
  robot.drive(3);
  EXPECT_LT(headingDeg(), -20);
  EXPECT_EQ(latest().rotationRateDeciDegS, -100);
  EXPECT_EQ(latest().leftSpeedMmS, 51) << "v - w / DiffConv, as MobileSim sends it";
  EXPECT_EQ(latest().rightSpeedMmS, -51);
  robot.send(CommandId::kHead, -90);
  robot.drive(5);
  EXPECT_NEAR(headingDeg(), -90, 0.6);
  EXPECT_NEAR(latest().headingSetpoint4096, -1024, 1);
  robot.send(CommandId::kDhead, 120);
  robot.drive(5);
  EXPECT_NEAR(headingDeg(), 30, 0.6);
}

TEST_F(ServerCommandsTest, moveEndsWhereItShould) {
  robot.send(CommandId::kSetV, 300);
  robot.send(CommandId::kMove, 500);
  robot.drive(5);
  EXPECT_NEAR(latest().xMm, 500, 4);
  robot.send(CommandId::kMove, -700);
  robot.drive(6);
  EXPECT_NEAR(latest().xMm, -200, 4);
}

TEST_F(ServerCommandsTest, wheelSpeedsAreInUnitsOf20MmPerSecond) {
  robot.send(CommandId::kVel2, joined({-5, 5}));
  robot.drive(3);
  EXPECT_EQ(latest().leftSpeedMmS, -100);
  EXPECT_EQ(latest().rightSpeedMmS, 100);
  robot.send(CommandId::kVel2, joined({10, 8}));
  robot.drive(3);
  EXPECT_EQ(latest().leftSpeedMmS, 200);
  EXPECT_EQ(latest().rightSpeedMmS, 160);
}

TEST_F(ServerCommandsTest, limitsComeInABurstAndHold) {
  robot.send(CommandId::kSetV, 100);
  robot.send(CommandId::kSetA, 50);
  robot.send(CommandId::kSetA, -1000);
  robot.send(CommandId::kSetRv, 20);
  robot.send(CommandId::kSetRa, 10);
  robot.send(CommandId::kSetRa, -100);
  robot.send(CommandId::kVel, 500);
  robot.send(CommandId::kRvel, 90);
  robot.drive(1);
  EXPECT_NEAR(latest().leftSpeedMmS + latest().rightSpeedMmS, 100, 4) << "50 mm/s2 for a second";
  EXPECT_NEAR(*latest().rotationRateDeciDegS, 100, 4);
  robot.drive(2);
  EXPECT_EQ(latest().leftSpeedMmS + latest().rightSpeedMmS, 200);
  EXPECT_EQ(latest().rotationRateDeciDegS, 200);
}

TEST_F(ServerCommandsTest, stopLeavesTheMotorsOn) {
  robot.send(CommandId::kVel, 300);
  robot.drive(2);
  robot.send(CommandId::kStop);
  robot.drive(2);
  EXPECT_EQ(latest().leftSpeedMmS, 0);
  EXPECT_TRUE(latest().motorsOn());
  robot.send(CommandId::kVel, 300);
  robot.drive(2);
  robot.send(CommandId::kEStop);
  robot.run(0.1);
  EXPECT_EQ(latest().leftSpeedMmS, 0);
}

TEST_F(ServerCommandsTest, setOdometryZeroes) {
  robot.send(CommandId::kVel, 300);
  robot.send(CommandId::kRvel, 20);
  robot.drive(3);
  robot.send(CommandId::kStop);
  robot.drive(2);
  robot.send(CommandId::kSetO);
  robot.run(0.1);
  EXPECT_EQ(latest().xMm, 0);
  EXPECT_EQ(latest().yMm, 0);
  EXPECT_EQ(latest().heading4096, 0);
}

TEST_F(ServerCommandsTest, sonarsFireInTurnAndAreSentOnce) {
  robot.forget();
  robot.shots.clear();
  robot.drive(3.2);
  int reported = 0;
  std::set<int> numbers;
  for (const Sip& sip : robot.information()) {
    EXPECT_GE(sip.sonars.size(), 4U);
    EXPECT_LE(sip.sonars.size(), 6U);
    for (const auto& sonar : sip.sonars) {
      ++reported;
      numbers.insert(sonar.number);
      EXPECT_EQ(sonar.rangeMm, 1000 + 100 * sonar.number);
    }
  }
  EXPECT_THAT(numbers, SizeIs(16));
  EXPECT_NEAR(reported, 160, 4) << "each ten times in 3.2 s";
  robot.send(CommandId::kSonar, 0);
  robot.run(0.1);
  robot.shots.clear();
  robot.run(1);
  EXPECT_THAT(robot.shots, IsEmpty()) << "nothing is measured that nobody asked for";
  EXPECT_THAT(latest().sonars, IsEmpty());
}

TEST(ServerCommands, allSonarsCanComeInEachPacket) {
  ServerSettings settings;
  settings.allSonarsEachCycle = true;
  IdealRobot robot(settings);
  robot.connect();
  robot.run(1);
  for (const Sip& sip : robot.information()) EXPECT_THAT(sip.sonars, SizeIs(16));
  EXPECT_EQ(robot.shots[3], 10);
}

TEST_F(ServerCommandsTest, thereIsNoEchoBeyondTheMaximum) {
  struct Far final : RangeFinders {
    double sonar(int) override { return std::numeric_limits<double>::infinity(); }
    std::span<const double> laser() override { return {}; }
  } far;
  ServerSession session;
  for (const auto id : {CommandId::kSync0, CommandId::kSync1, CommandId::kSync2, CommandId::kOpen}) {
    session.take(toPacket(command(id)), {});
  }
  for (int i = 0; i < 50; ++i) session.step({}, far, Instant(i * IdealWheels::kStep));
  std::vector<Sip::Sonar> sonars;
  for (const Packet& packet : session.takeOutgoing()) {
    if (const auto sip = decode<StandardInformation>(packet))
      sonars.insert(sonars.end(), sip->sonars.begin(), sip->sonars.end());
  }
  ASSERT_FALSE(sonars.empty());
  for (const auto& sonar : sonars) EXPECT_EQ(sonar.rangeMm, 5000);
}

TEST_F(ServerCommandsTest, requestedPacketsComeOnceOrAsAStream) {
  robot.send(CommandId::kEncoder, 1);
  robot.send(CommandId::kIoRequest, 2);
  robot.send(CommandId::kImuRequest, 1);
  robot.send(CommandId::kJoyRequest, 1);
  robot.send(CommandId::kBatteryInfo, 1);
  robot.send(CommandId::kGyro, 2);
  robot.drive(1);
  EXPECT_THAT(robot.of(EncoderPacket::kId), SizeIs(1));
  EXPECT_THAT(robot.of(ImuPacket::kId), SizeIs(1));
  EXPECT_THAT(robot.of(JoystickPacket::kId), SizeIs(1));
  EXPECT_THAT(robot.of(BatteryPacket::kId), SizeIs(1));
  EXPECT_THAT(robot.of(IoPacket::kId), SizeIs(10));
  EXPECT_THAT(robot.of(GyroPacket::kId), SizeIs(10));
  robot.send(CommandId::kIoRequest, 0);
  robot.send(CommandId::kGyro, 0);
  robot.forget();
  robot.drive(1);
  EXPECT_THAT(robot.received, SizeIs(10));
}

TEST_F(ServerCommandsTest, gyroscopeAndJoystickComeBeforeTheInformationAndTheOthersAfterIt) {
  robot.send(CommandId::kEncoder, 2);
  robot.send(CommandId::kIoRequest, 2);
  robot.send(CommandId::kGyro, 2);
  robot.send(CommandId::kJoyRequest, 2);
  robot.run(0.1);
  robot.forget();
  robot.run(0.1);
  std::vector<int> order;
  for (const Packet& packet : robot.received) order.push_back(packet.id);
  EXPECT_EQ(order, (std::vector<int>{0x98, 0xF8, 0x32, 0xF0, 0x90}));
}

TEST_F(ServerCommandsTest, encodersCountTicksOfTheRims) {
  robot.send(CommandId::kVel, 300);
  robot.drive(2);
  robot.send(CommandId::kEncoder, 1);
  robot.run(0.2);
  const auto encoder = decode<EncoderPacket>(robot.of(EncoderPacket::kId).at(0));
  ASSERT_TRUE(encoder);
  EXPECT_NEAR(encoder->leftTicks, robot.sensing.leftTravel * 138000, 6000);
  EXPECT_GT(encoder->leftTicks, 30000);
}

TEST_F(ServerCommandsTest, theGyroscopeIsReadAsAriaDoes) {
  robot.sensing.rotationRate = radians(30.0);
  robot.send(CommandId::kGyro, 2);
  robot.drive(1);
  const auto gyro = decode<GyroPacket>(robot.of(GyroPacket::kId).back());
  ASSERT_TRUE(gyro);
  ASSERT_THAT(gyro->readings, SizeIs(testing::AllOf(testing::Ge(3U), testing::Le(4U))));
  for (const auto& reading : gyro->readings) {
    EXPECT_NEAR(-(reading.rate - 512.0) * 5 / 1023 * 300 / 2.5 * 1.626, 30, 0.5);
  }
}

TEST_F(ServerCommandsTest, gyroscopesReadingsAddUpToTheTurn) {
  robot.sensing.rotationRate = radians(20.0);
  robot.send(CommandId::kGyro, 1);
  robot.drive(5);
  double turned = 0;
  for (const Packet& packet : robot.of(GyroPacket::kId)) {
    const auto gyro = decode<GyroPacket>(packet);
    ASSERT_TRUE(gyro);
    for (const auto& reading : gyro->readings) {
      turned += 0.025 * -(reading.rate - 512.0) * 5 / 1023 * 300 / 2.5 * 1.626;
    }
  }
  EXPECT_NEAR(turned, 100, 3) << "as ARIA sums them up";
}

TEST_F(ServerCommandsTest, bumpersInIoPacketsAreLowWherePressed) {
  robot.sensing.frontBumpers = 0b10;
  robot.send(CommandId::kIoRequest, 1);
  robot.run(0.2);
  const auto io = decode<IoPacket>(robot.of(IoPacket::kId).at(0));
  ASSERT_TRUE(io);
  ASSERT_THAT(io->digitalIn, SizeIs(4));
  EXPECT_EQ(io->digitalIn[1], 0b11111011);
  EXPECT_EQ(io->digitalIn[2], 0xFF);
  EXPECT_THAT(io->analog, SizeIs(9));
}

TEST_F(ServerCommandsTest, digitalOutputsChangeWhereTheMaskSaysSo) {
  robot.send(CommandId::kDigOut, 25 * 256 + 9);
  robot.run(0.1);
  EXPECT_EQ(latest().digitalOut, 9);
  robot.send(CommandId::kDigOut, 1 * 256 + 0);
  robot.run(0.1);
  EXPECT_EQ(latest().digitalOut, 8);
}

TEST_F(ServerCommandsTest, theBatteryIsSentAndCanBePretended) {
  robot.sensing.battery = 12.34;
  robot.run(0.1);
  EXPECT_EQ(latest().batteryDecivolts, 123);
  EXPECT_EQ(latest().chargeState, 0);
  EXPECT_EQ(latest().faultFlags, 0);
  robot.send(CommandId::kBatTest, 108);
  robot.run(0.1);
  EXPECT_EQ(latest().batteryDecivolts16, 108);
  EXPECT_EQ(latest().faultFlags, Sip::kLowBatteryShutdown);
  robot.send(CommandId::kBatTest, 0);
  robot.run(0.1);
  EXPECT_EQ(latest().batteryDecivolts, 123);
}

TEST_F(ServerCommandsTest, aLaserComesByTheOldCommandsAndByTheNew) {
  for (int i = 0; i < 181; ++i) robot.scan[static_cast<std::size_t>(i)] = 1 + 0.01 * i;
  const auto ask = [&](CommandId start, CommandId end, CommandId resolution, CommandId enable, int mode) {
    robot.forget();
    robot.send(start, -90);
    robot.send(end, 90);
    robot.send(resolution, 100);
    robot.send(enable, mode);
    robot.run(0.1);
  };
  ask(CommandId::kLegacyLaserStart, CommandId::kLegacyLaserEnd, CommandId::kLegacyLaserResolution,
      CommandId::kLegacyLaserEnable, 2);
  EXPECT_THAT(robot.of(LaserPacket::kExtendedId), SizeIs(6));
  EXPECT_EQ(robot.received[0].id, 0x32) << "after the information packet";
  ask(CommandId::kSimLaserStart, CommandId::kSimLaserEnd, CommandId::kSimLaserResolution,
      CommandId::kSimLaserEnable, 1);
  const auto parts = robot.of(LaserPacket::kPlainId);
  int next = 0;
  for (const Packet& packet : parts) {
    const auto part = decode<LaserPacket>(packet);
    ASSERT_TRUE(part);
    EXPECT_EQ(part->total, 181);
    EXPECT_EQ(part->first, next);
    for (const auto& reading : part->readings) EXPECT_EQ(reading.rangeMm, 1000 + 10 * next++);
  }
  EXPECT_EQ(next, 181);
  robot.send(CommandId::kSimLaserEnable, 0);
  robot.forget();
  robot.run(0.5);
  EXPECT_THAT(robot.received, SizeIs(5));
}

TEST_F(ServerCommandsTest, aLaserLooksOnlyWhereItIsAskedTo) {
  for (int i = 0; i < 181; ++i) robot.scan[static_cast<std::size_t>(i)] = 1 + 0.01 * i;
  robot.send(CommandId::kSimLaserStart, -10);
  robot.send(CommandId::kSimLaserEnd, 30);
  robot.send(CommandId::kSimLaserResolution, 200);
  robot.send(CommandId::kSimLaserEnable, 1);
  robot.run(0.1);
  const auto part = decode<LaserPacket>(robot.of(LaserPacket::kPlainId).at(0));
  ASSERT_TRUE(part);
  ASSERT_THAT(part->readings, SizeIs(21));
  EXPECT_EQ(part->readings.front().rangeMm, 1000 + 10 * 80);
  EXPECT_EQ(part->readings.back().rangeMm, 1000 + 10 * 120);
}

TEST_F(ServerCommandsTest, whatIsAskedOfTheGripperDoesNotMoveTheLaser) {
  const auto field = [&] {
    robot.forget();
    robot.run(0.15);
    const auto parts = robot.of(LaserPacket::kExtendedId);
    return parts.empty() ? 0 : int{decode<LaserPacket>(parts[0])->total};
  };
  robot.send(CommandId::kLegacyLaserStart, -90);
  robot.send(CommandId::kPulse);
  robot.send(CommandId::kLegacyLaserEnd, 90);
  robot.send(CommandId::kLegacyLaserEnable, 2);
  ASSERT_EQ(field(), 181);
  robot.send(CommandId::kGripperRequest, 1);
  EXPECT_EQ(field(), 181);
  EXPECT_THAT(robot.of(GripperPacket::kId), SizeIs(1)) << "it says that there is none";
  EXPECT_EQ(field(), 181);
  EXPECT_THAT(robot.of(GripperPacket::kId), IsEmpty());
  robot.send(CommandId::kGripper, 16);
  robot.send(CommandId::kGripperValue, 30);
  EXPECT_EQ(field(), 181) << "a pressure is no angle";
  robot.send(CommandId::kAdSel, 5);
  EXPECT_EQ(field(), 181) << "an analog port is no mode of the laser";
  robot.send(CommandId::kLegacyLaserStart, -2);
  robot.send(CommandId::kLegacyLaserEnd, 2);
  EXPECT_EQ(field(), 5) << "right after the start it is the laser's end";
}

TEST_F(ServerCommandsTest, itsStatusSaysOnlyWhatIsSo) {
  const auto status = [&] {
    robot.forget();
    robot.send(CommandId::kSimStat, 1);
    robot.run(0.15);
    return *decode<SimulatorStatus>(robot.of(SimulatorStatus::kId).at(0));
  };
  EXPECT_EQ(status().flags, 0U) << "neither a place on Earth nor an error of the odometry";
  robot.sensing.globalPosition = GlobalPosition{42.807191, -71.578661, 72.5};
  robot.sensing.odometryError = -0.002;
  const auto reported = status();
  EXPECT_EQ(reported.flags, SimulatorStatus::kHasGlobalPosition | SimulatorStatus::kHasOdometryError);
  EXPECT_EQ(reported.latitude1e7, 428071910);
  EXPECT_EQ(reported.longitude1e7, -715786610);
  EXPECT_EQ(reported.altitudeCm, 7250);
  EXPECT_EQ(reported.positionQuality, 100)
      << "clients take a hundredth of it for the dilution of precision; 0 is bad";
  EXPECT_EQ(reported.odometryErrorX1e7, -20000);
}

TEST_F(ServerCommandsTest, withoutALaserItsCommandsAreIgnored) {
  ServerSettings settings;
  settings.laser.reset();
  IdealRobot blind(settings);
  blind.connect();
  blind.send(CommandId::kLegacyLaserEnable, 2);
  blind.run(0.5);
  EXPECT_EQ(blind.scans, 0);
  EXPECT_THAT(blind.of(LaserPacket::kExtendedId), IsEmpty());
}

TEST_F(ServerCommandsTest, theSimulatorIsAskedThroughValues) {
  using namespace simulator_request;
  robot.send({224, {0, 0xE8, 3, 0, 0, 0x18, 0xFC, 0xFF, 0xFF, 90, 0, 0, 0}});
  robot.send(CommandId::kSimReset);
  robot.send(CommandId::kSimMessage, "hello");
  robot.send(CommandId::kSimExit, 3);
  robot.send({236, {0x2B, 1, 0, 5, 0, 'a', '.', 'm', 'a', 'p', 'x'}});
  const auto requests = robot.session.takeRequests();
  ASSERT_THAT(requests, SizeIs(5));
  const auto& pose = std::get<SetPose>(requests[0]).pose;
  EXPECT_DOUBLE_EQ(pose.x, 1);
  EXPECT_DOUBLE_EQ(pose.y, -1);
  EXPECT_NEAR(pose.heading, kPi / 2, 1e-9);
  EXPECT_TRUE(std::holds_alternative<Reset>(requests[1]));
  EXPECT_EQ(std::get<Message>(requests[2]).text, "hello");
  EXPECT_EQ(std::get<Exit>(requests[3]).status, 3);
  EXPECT_EQ(std::get<LoadMap>(requests[4]).file, "a.map");
}

TEST_F(ServerCommandsTest, theSimulatorSendsItsNameItsTruthAndItsMap) {
  robot.sensing.truePose = {1.5, -2, radians(90.0)};
  robot.send({236, {0x2B, 6, 0}});
  robot.send(CommandId::kSimStat, 1);
  robot.session.mapLoaded("office.map", true, false);
  robot.run(0.3);
  const auto info = decode<SimulatorInfo>(robot.of(SimulatorInfo::kId).at(0));
  ASSERT_TRUE(info);
  EXPECT_EQ(info->application, "RobotControl");
  EXPECT_THAT(info->devices, SizeIs(3));
  ASSERT_THAT(robot.of(SimulatorStatus::kId), SizeIs(1));
  const auto status = decode<SimulatorStatus>(robot.of(SimulatorStatus::kId).at(0));
  ASSERT_TRUE(status);
  EXPECT_EQ(status->xMm, 1500);
  EXPECT_EQ(status->yMm, -2000);
  EXPECT_EQ(status->headingDeg, 90);
  const auto map = decode<MapChanged>(robot.of(MapChanged::kId).at(0));
  ASSERT_TRUE(map);
  EXPECT_EQ(map->file, "office.map");
  EXPECT_EQ(map->loaded, 1);
  robot.session.mapLoaded(std::string(1000, 'x') + "/b.map", true, true);
  robot.run(0.1);
  EXPECT_THAT(robot.of(MapChanged::kId), SizeIs(2)) << "of long paths the end is sent";
}

TEST(ServerCommands, aGyroscopeOfTheRobotsOwnMakesItsHeading) {
  ServerSettings settings;
  settings.gyroscope = ServerSettings::Gyroscope::kRobot;
  IdealRobot robot(settings);
  robot.connect();
  robot.send(CommandId::kEnable, 1);
  robot.sensing.rotationRate = radians(10.0);  // what the wheels do not show
  robot.drive(2);
  EXPECT_EQ(robot.information().back().heading4096, 0) << "a robot that stands does not drift";
  robot.send(CommandId::kVel, 200);
  robot.drive(2);
  EXPECT_NEAR(robot.information().back().heading4096 * 360.0 / 4096, 20, 1);
  EXPECT_THAT(robot.of(GyroPacket::kId), IsEmpty());
  robot.send(CommandId::kGyro, 0);
  robot.send(CommandId::kSetO);
  robot.drive(2);
  EXPECT_EQ(robot.information().back().heading4096, 0) << "switched off, the wheels count";
}

}  // namespace
