// SPDX-License-Identifier: GPL-3.0-or-later
// Handshake, cycle, watchdog, and what else makes a robot's side of a connection.
#include "robotlink/arcos/server/ServerSession.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/robotlink/arcos/IdealRobot.h"

namespace {

using namespace robotlink;
using namespace robotlink::arcos;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;
using Sip = StandardInformation;

class ServerSessionTest : public testing::Test {
 protected:
  IdealRobot robot;

  Sip latest() const { return robot.information().back(); }
};

TEST_F(ServerSessionTest, syncsAreEchoedAndTheThirdIsAnsweredWithTheIdentity) {
  robot.send(CommandId::kSync0);
  robot.send(CommandId::kSync1);
  EXPECT_THAT(robot.received, ElementsAre(Packet{0, {}}, Packet{1, {}}));
  robot.send(CommandId::kSync2);
  ASSERT_THAT(robot.received, SizeIs(3));
  const auto identity = decode<Identity>(robot.received[2]);
  ASSERT_TRUE(identity);
  EXPECT_EQ(identity->name, "MobileSim");
  EXPECT_EQ(identity->robotClass, "Pioneer");
  EXPECT_EQ(identity->subclass, "p3at-sh");
  robot.run(1);
  EXPECT_THAT(robot.received, SizeIs(3)) << "nothing goes out before OPEN";
}

TEST_F(ServerSessionTest, aCloseBeforeTheHandshakeIsNotTakenForItsThirdStep) {
  robot.send(CommandId::kClose);
  robot.send(CommandId::kSync0);
  EXPECT_THAT(robot.received, ElementsAre(Packet{0, {}}));
  robot.send(CommandId::kClose);
  EXPECT_THAT(robot.received, SizeIs(1));
  robot.send(CommandId::kSync1);
  EXPECT_THAT(robot.received, SizeIs(1)) << "the handshake begins with SYNC0";
  robot.connect();
  EXPECT_EQ(robot.session.state(), ServerSession::State::kOpen);
}

TEST_F(ServerSessionTest, handshakesMayRepeatAndBeginAnew) {
  for (const auto id : {CommandId::kSync0, CommandId::kSync0, CommandId::kSync1, CommandId::kSync1,
                        CommandId::kSync2, CommandId::kSync2}) {
    robot.send(id);
  }
  EXPECT_THAT(robot.received, SizeIs(6));
  EXPECT_EQ(robot.session.state(), ServerSession::State::kIdentified);
  robot.connect();
  EXPECT_EQ(robot.session.state(), ServerSession::State::kOpen);
}

TEST_F(ServerSessionTest, otherCommandsBeforeTheHandshakeDoNothing) {
  robot.send(CommandId::kConfig, 1);
  robot.send(CommandId::kEnable, 1);
  robot.send(CommandId::kSimReset);
  EXPECT_THAT(robot.received, IsEmpty());
  EXPECT_THAT(robot.session.takeRequests(), IsEmpty());
  robot.connect();
  robot.run(0.5);
  EXPECT_FALSE(latest().motorsOn());
}

TEST_F(ServerSessionTest, informationComesTenTimesASecond) {
  robot.connect();
  const Instant opened = robot.now;
  robot.forget();
  robot.drive(10);
  ASSERT_THAT(robot.received, SizeIs(100));
  EXPECT_LE(robot.receivedAt[0] - opened, std::chrono::milliseconds(200));
  for (std::size_t i = 1; i < robot.receivedAt.size(); ++i) {
    EXPECT_EQ(robot.receivedAt[i] - robot.receivedAt[i - 1], std::chrono::milliseconds(100));
  }
}

TEST_F(ServerSessionTest, configurationIsSentWithAndWithoutArgument) {
  robot.connect();
  robot.forget();
  robot.send(CommandId::kConfig);
  robot.send(CommandId::kConfig, 1);
  ASSERT_THAT(robot.of(Configuration::kId), SizeIs(2));
  const auto reported = decode<Configuration>(robot.received[0]);
  ASSERT_TRUE(reported);
  EXPECT_EQ(reported->type, "Pioneer");
  EXPECT_EQ(reported->subtype, "p3at-sh");
  EXPECT_EQ(reported->serialNumber, "SIM");
  EXPECT_EQ(reported->name, "MobileSim");
  EXPECT_EQ(reported->transVelTopMmS, 1500);
  EXPECT_EQ(reported->transVelMaxMmS, 750);
  EXPECT_EQ(reported->rotVelTopDegS, 300);
  EXPECT_EQ(reported->rotVelMaxDegS, 100);
  EXPECT_EQ(reported->transAccMmS2, 300);
  EXPECT_EQ(reported->rotDecelDegS2, 100);
  EXPECT_EQ(reported->sipCycleMs, 100);
  EXPECT_EQ(reported->watchdogMs, 2000);
  EXPECT_EQ(reported->ticksMm, 138);
  EXPECT_NEAR(reported->revCount, 31900, 100);
  EXPECT_EQ(reported->autoBaud, 2);
}

TEST_F(ServerSessionTest, closeStopsEverythingAndANewHandshakeBeginsWithDefaults) {
  robot.connect();
  robot.send(CommandId::kEnable, 1);
  robot.send(CommandId::kSetV, 200);
  robot.send(CommandId::kSonar, 0);
  robot.send(CommandId::kLegacyLaserEnable, 2);
  robot.send(CommandId::kIoRequest, 2);
  robot.send(CommandId::kVel, 200);
  robot.drive(2);
  robot.send(CommandId::kClose, 1);
  robot.send(CommandId::kClose, 1);
  robot.forget();
  robot.run(1);
  EXPECT_THAT(robot.received, IsEmpty());
  EXPECT_FALSE(robot.wheels.command.motorsOn);
  EXPECT_EQ(robot.session.motion().parameters().speed, 0.75);
  robot.connect();
  robot.forget();
  robot.run(0.5);
  EXPECT_THAT(robot.received, SizeIs(5)) << "nothing but information packets";
  EXPECT_TRUE(latest().sonarOn());
  EXPECT_EQ(latest().xMm, 0) << "the odometry begins where it is opened";
}

TEST_F(ServerSessionTest, aClientThatGoesLeavesARobotThatStands) {
  robot.connect();
  robot.send(CommandId::kEnable, 1);
  robot.send(CommandId::kVel, 300);
  robot.drive(2);
  EXPECT_GT(robot.wheels.command.left, 0.2);
  robot.session.clientGone(robot.now);
  robot.forget();
  robot.step();
  EXPECT_FALSE(robot.wheels.command.motorsOn);
  EXPECT_EQ(robot.session.state(), ServerSession::State::kWaiting);
  robot.run(3);
  EXPECT_THAT(robot.received, IsEmpty());
  robot.connect();
  robot.run(0.2);
  EXPECT_FALSE(latest().motorsOn());
}

TEST_F(ServerSessionTest, twoSecondsOfSilenceStopItAndTheNextPacketResumes) {
  robot.connect();
  robot.send(CommandId::kEnable, 1);
  robot.send(CommandId::kVel, 200);
  robot.drive(4);
  robot.send(CommandId::kPulse);
  robot.run(1.95);
  EXPECT_NEAR(robot.wheels.command.left, 0.2, 1e-9);
  robot.run(1);
  EXPECT_TRUE(robot.session.starved());
  EXPECT_EQ(robot.wheels.command.left, 0);
  EXPECT_TRUE(robot.wheels.command.motorsOn);
  robot.send({111, {}});  // any packet, known or not
  robot.run(1);
  EXPECT_NEAR(robot.wheels.command.left, 0.2, 1e-9);
}

TEST(ServerSession, theWatchdogCanBeSwitchedOff) {
  ServerSettings settings;
  settings.watchdogStops = false;
  IdealRobot robot(settings);
  robot.connect();
  robot.send(CommandId::kEnable, 1);
  robot.send(CommandId::kVel, 200);
  robot.run(5);
  EXPECT_NEAR(robot.wheels.command.left, 0.2, 1e-9);
}

TEST_F(ServerSessionTest, flagsFollowMotorsAndSonars) {
  robot.connect();
  robot.run(0.2);
  EXPECT_EQ(latest().flags, Sip::kSonarArray1On | Sip::kSonarArray1On << 1);
  robot.send(CommandId::kEnable, 1);
  robot.run(0.2);
  EXPECT_TRUE(latest().motorsOn());
  robot.send(CommandId::kEnable, 0);
  robot.send(CommandId::kSonar, 0);
  robot.run(0.2);
  EXPECT_EQ(latest().flags, 0);
  robot.send(CommandId::kSonar, 1);
  robot.run(0.2);
  EXPECT_TRUE(latest().sonarOn());
}

TEST_F(ServerSessionTest, theStopButtonSwitchesTheMotorsOff) {
  robot.connect();
  robot.send(CommandId::kEnable, 1);
  robot.send(CommandId::kVel, 200);
  robot.drive(1);
  robot.sensing.stopButton = true;
  robot.send(CommandId::kEnable, 1);
  robot.run(0.2);
  EXPECT_FALSE(latest().motorsOn());
  EXPECT_TRUE(latest().flags & Sip::kEmergencyStop);
  EXPECT_FALSE(robot.wheels.command.motorsOn);
}

TEST_F(ServerSessionTest, informationSaysWhetherTheRobotMoves) {
  robot.connect();
  robot.run(0.2);
  EXPECT_FALSE(latest().moving);
  robot.send(CommandId::kEnable, 1);
  robot.send(CommandId::kVel, 200);
  robot.drive(1);
  EXPECT_TRUE(latest().moving);
  EXPECT_EQ(latest().leftSpeedMmS, 200);
  EXPECT_EQ(latest().rightSpeedMmS, 200);
}

TEST_F(ServerSessionTest, stallsAndBumpersAreSent) {
  robot.connect();
  robot.send(CommandId::kEnable, 1);
  robot.send(CommandId::kVel, 200);
  robot.drive(1);
  robot.sensing.rightBlocked = true;
  robot.sensing.frontBumpers = 0b00101;
  robot.sensing.rearBumpers = 0b110000;  // its sixth segment it does not have
  robot.run(0.15);
  EXPECT_FALSE(latest().leftStalled());
  EXPECT_TRUE(latest().rightStalled());
  EXPECT_EQ(latest().frontBumpers(), 0b00101U);
  EXPECT_EQ(latest().rearBumpers(), 0b10000U);
  robot.sensing.rightBlocked = false;
  robot.run(0.5);
  EXPECT_FALSE(latest().rightStalled()) << "cleared afterwards";
}

TEST_F(ServerSessionTest, bumpersCountAsStallOnlyIfAskedFor) {
  robot.connect();
  robot.send(CommandId::kEnable, 1);
  robot.send(CommandId::kVel, 200);
  robot.sensing.rearBumpers = 1;
  robot.drive(1);
  EXPECT_FALSE(latest().leftStalled());
  robot.send(CommandId::kBumpStall, 1);
  robot.run(0.5);
  EXPECT_FALSE(latest().leftStalled()) << "the rear ones do not count";
  robot.send(CommandId::kBumpStall, 2);
  robot.run(0.2);
  EXPECT_TRUE(latest().leftStalled());
}

TEST_F(ServerSessionTest, odometryWrapsAt16Bits) {
  robot.connect();
  robot.step();
  robot.sensing.leftTravel = robot.sensing.rightTravel = robot.wheels.wheels.leftTravel =
      robot.wheels.wheels.rightTravel = 32.760;
  robot.run(0.2);
  EXPECT_EQ(latest().xMm, 32760);
  robot.wheels.wheels.leftTravel = robot.wheels.wheels.rightTravel = 32.780;
  robot.run(0.2);
  EXPECT_EQ(latest().xMm, 32780 - 65536);
  robot.wheels.wheels.leftTravel = robot.wheels.wheels.rightTravel = -70;
  robot.run(0.2);
  EXPECT_EQ(latest().xMm, -70000 + 65536);
}

TEST_F(ServerSessionTest, whatGoesOutIsBounded) {
  robot.connect();
  for (int i = 0; i < 5000; ++i) robot.session.take(toPacket(command(CommandId::kConfig)), robot.now);
  EXPECT_THAT(robot.session.takeOutgoing(), SizeIs(ServerSession::kMaxOutgoing));
  EXPECT_EQ(robot.session.droppedPackets(), 5000 - ServerSession::kMaxOutgoing);
  for (int i = 0; i < 5000; ++i) robot.session.take(toPacket(command(CommandId::kSimReset)), robot.now);
  EXPECT_LE(robot.session.takeRequests().size(), 64U);
}

TEST_F(ServerSessionTest, resetAndMaintenanceAreHarmless) {
  robot.connect();
  robot.send(CommandId::kEnable, 1);
  robot.send(CommandId::kReset);
  robot.send(CommandId::kMaintenance);
  robot.send({254, {}});
  robot.run(0.5);
  EXPECT_EQ(robot.session.state(), ServerSession::State::kOpen);
  EXPECT_TRUE(latest().motorsOn());
  for (const Packet& packet : robot.received) EXPECT_LT(packet.id, 0xFE);
}

TEST_F(ServerSessionTest, everyCommandNumberIsTakenWithAnyArgument) {
  robot.connect();
  for (int id = 3; id < 256; ++id) {
    for (const Bytes& data :
         {Bytes{}, Bytes{0x3B}, Bytes{0x3B, 1}, Bytes{0x1B, 255, 255}, Bytes{0x2B, 200, 'x'}, Bytes{0x2B, 0},
          Bytes{0x7F, 1, 2, 3}, Bytes(246, 0x2B)}) {
      robot.send({static_cast<std::uint8_t>(id), data});
    }
    robot.run(0.1);
  }
  robot.session.takeRequests();
  EXPECT_EQ(robot.session.state(), ServerSession::State::kOpen);
  for (const Packet& packet : robot.received) {
    EXPECT_LT(packet.id, 0xFE);
    EXPECT_LE(packet.count(), kMaxSentCount);
  }
}

}  // namespace
