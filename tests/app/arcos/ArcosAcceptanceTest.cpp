// SPDX-License-Identifier: GPL-3.0-or-later
// What a robot's TCP port must do so that unmodified clients can use it, over real sockets on loopback; time
// is the simulation's. This part is about the protocol: C1 to C8 and C14 to C18 of the checks;
// ArcosDrivingTest has the others, RobotctlArcosTest C3 by the clock.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "robotlink/base/Random.h"
#include "tests/app/arcos/ArcosBench.h"

namespace app {
namespace {

using namespace robotlink;
using namespace robotlink::arcos;
using namespace std::chrono_literals;
using testing::AllOf;
using testing::ElementsAre;
using testing::Ge;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Le;
using testing::SizeIs;

constexpr double kNoTime = 0.2;  // s; what the next information packet takes at most

TEST(ArcosAcceptance, c1TwentyClientsInARowAtTheSamePort) {
  ArcosBench bench;
  const std::string url = bench.simulation().ports().url(0);
  for (int i = 0; i < 20; ++i) {
    WireClient& client = bench.connect();
    client.handshake();
    client.send(CommandId::kEnable, 1);
    ASSERT_TRUE(bench.runUntil([&] { return !client.information().empty(); }, 1)) << i;
    if (i % 2 == 0) client.send(CommandId::kClose, 1);  // others just go
    client.close();
  }
  EXPECT_EQ(bench.simulation().ports().url(0), url);
  EXPECT_EQ(bench.simulation().ports().ports().statistics(0).refused, 0U);
}

TEST(ArcosAcceptance, c1RobotsListenAtPortsOneAfterTheOther) {
  ArcosBench bench(
      "<include><uri>model://p3at</uri><name>p3at2</name><pose>2 0 0 0 0 0</pose></include>"
      "<include><uri>model://p3at</uri><name>p3at3</name><pose>0 2 0 0 0 0</pose></include>");
  ASSERT_THAT(bench.world().pioneers(), SizeIs(3));
  const auto& ports = bench.simulation().ports().ports();
  EXPECT_NE(ports.port(0), ports.port(1));
  for (std::size_t robot = 0; robot < 3; ++robot) {
    WireClient& client = bench.connect(robot);
    client.handshake();
    client.send(CommandId::kEnable, static_cast<int>(robot) % 2);
    EXPECT_TRUE(bench.runUntil([&] { return client.information().size() == 3; }, 1));
    EXPECT_EQ(client.latest().motorsOn(), robot % 2 == 1);
  }
}

TEST(ArcosAcceptance, c2SyncsAreEchoedWithinASecond) {
  ArcosBench bench;
  WireClient& client = bench.connect();
  client.send(CommandId::kSync0);
  ASSERT_TRUE(bench.runUntil([&] { return client.received.size() == 1; }, 1));
  client.send(CommandId::kSync1);
  ASSERT_TRUE(bench.runUntil([&] { return client.received.size() == 2; }, 1));
  client.send(CommandId::kSync2);
  ASSERT_TRUE(bench.runUntil([&] { return client.received.size() == 3; }, 1));
  EXPECT_EQ(client.received[0], (Packet{0, {}}));
  EXPECT_EQ(client.received[1], (Packet{1, {}}));
  const auto identity = decode<Identity>(client.received[2]);
  ASSERT_TRUE(identity);
  EXPECT_EQ(identity->robotClass, "Pioneer");
  EXPECT_EQ(identity->subclass, "p3at-sh");
  EXPECT_LT(client.receivedAt[2] - client.receivedAt[0], 1s);
}

TEST(ArcosAcceptance, c3InformationComesAtTenHertzFromOpenOn) {
  ArcosBench bench;
  WireClient& client = bench.connect();
  for (const auto id : {CommandId::kSync0, CommandId::kSync1, CommandId::kSync2}) client.send(id);
  bench.run(1);
  EXPECT_THAT(client.received, SizeIs(3)) << "nothing before OPEN";
  client.forget();
  const Instant opened = bench.now();
  client.send(CommandId::kOpen);
  bench.drive(20);
  EXPECT_LE(client.receivedAt.front() - opened, 220ms);
  EXPECT_NEAR(static_cast<double>(client.information().size()), 200, 1);
  for (std::size_t i = 1; i < client.receivedAt.size(); ++i) {
    EXPECT_LE(client.receivedAt[i] - client.receivedAt[i - 1], 110ms);
  }
}

TEST(ArcosAcceptance, c4ConfigurationWithAndWithoutArgument) {
  ArcosBench bench;
  WireClient& client = bench.connect();
  client.handshake();
  for (const Packet& request : {Packet{18, {}}, Packet{18, {0x3B, 1, 0}}}) {
    client.forget();
    client.send(request);
    ASSERT_TRUE(bench.runUntil([&] { return !client.of(Configuration::kId).empty(); }, kNoTime));
    const auto reported = decode<Configuration>(client.of(Configuration::kId)[0]);
    ASSERT_TRUE(reported);
    EXPECT_EQ(reported->serialNumber, "SIM");
    EXPECT_EQ(reported->subtype, "p3at-sh");
    EXPECT_THAT(reported->transVelTopMmS, AllOf(Ge(1200), Le(1500)));
    EXPECT_THAT(reported->transVelMaxMmS, AllOf(Ge(700), Le(750)));
    EXPECT_THAT(reported->rotVelTopDegS, AllOf(Ge(300), Le(360)));
    EXPECT_THAT(reported->rotVelMaxDegS, AllOf(Ge(100), Le(140)));
    EXPECT_EQ(reported->frontBumpers, 5);
    EXPECT_EQ(reported->hasGyro, 1);
  }
}

TEST(ArcosAcceptance, c5GarbageSplitMergedAndDamagedPacketsDoNotEndTheSession) {
  ArcosBench bench;
  WireClient& client = bench.connect();
  client.handshake();
  Random random(5);
  Bytes garbage(3000);
  for (auto& byte : garbage) byte = static_cast<std::uint8_t>(random.bits() % 0xFA);  // no header in it
  client.send(garbage);
  const Bytes enable = encode(toPacket(command(CommandId::kEnable, 1)));
  for (const std::uint8_t byte : enable) client.send(std::span(&byte, 1));
  ASSERT_TRUE(bench.runUntil(
      [&] { return !client.received.empty() && bench.world().pioneers()[0]->session().motion().motorsOn(); },
      1));
  Bytes damaged = encode(toPacket(command(CommandId::kEnable, 0)));
  damaged.back() ^= 1;
  append(toPacket(command(CommandId::kVel, 100)), damaged);
  append(toPacket(command(CommandId::kSonar, 0)), damaged);
  client.send(damaged);
  bench.run(1);
  EXPECT_TRUE(client.latest().motorsOn()) << "the damaged packet was dropped";
  EXPECT_GT(client.latest().leftSpeedMmS, 80) << "those that came with it were not";
  EXPECT_FALSE(client.latest().sonarOn());
  EXPECT_GE(bench.simulation().ports().ports().statistics(0).received.checksumErrors, 1U);
}

TEST(ArcosAcceptance, c6WhatClientsAskOnConnectingDisturbsNothing) {
  ArcosBench bench;
  WireClient& client = bench.connect();
  client.handshake();
  for (int id = 3; id < 256; ++id) {
    if (id == 239) continue;  // SIM_EXIT
    client.send(Packet{static_cast<std::uint8_t>(id), {0x3B, 1, 0}});
  }
  for (const int id : {62, 92, 31, 26, 17, 19, 40, 123, 124, 149, 213, 214, 218, 111, 200}) {
    client.send(Packet{static_cast<std::uint8_t>(id), {0x3B, 1, 0}});
    client.send(Packet{static_cast<std::uint8_t>(id), {}});
  }
  client.forget();
  bench.run(1);
  EXPECT_EQ(client.information().size(), 10U);
  EXPECT_FALSE(client.closed());
  EXPECT_FALSE(bench.simulation().ports().exitRequest());
}

TEST(ArcosAcceptance, c7LimitsAndSignsOfEveryCommandOfMotion) {
  ArcosBench bench;
  WireClient& client = bench.connect();
  client.handshake();
  client.send(CommandId::kEnable, 1);
  for (const auto& [id, value] : std::vector<std::pair<CommandId, int>>{{CommandId::kSetV, 400},
                                                                        {CommandId::kSetA, 400},
                                                                        {CommandId::kSetA, -500},
                                                                        {CommandId::kSetRv, 60},
                                                                        {CommandId::kSetRa, 120},
                                                                        {CommandId::kSetRa, -120}}) {
    client.send(id, value);
  }
  client.send(CommandId::kVel, 1000);
  bench.drive(2.5);
  EXPECT_NEAR(client.latest().leftSpeedMmS, 400, 15) << "SETV limits VEL";
  client.send(CommandId::kVel, -200);
  bench.drive(3);
  EXPECT_NEAR(client.latest().rightSpeedMmS, -200, 15);
  client.send(CommandId::kStop);
  bench.drive(1.5);
  EXPECT_NEAR(client.latest().rightSpeedMmS, 0, 5);
  EXPECT_TRUE(client.latest().motorsOn());
  client.send(CommandId::kRvel, 30);
  bench.drive(2);
  EXPECT_NEAR(*client.latest().rotationRateDeciDegS, 300, 30);
  client.send(CommandId::kRvel, -30);
  bench.drive(2);
  EXPECT_NEAR(*client.latest().rotationRateDeciDegS, -300, 30);
  client.send(CommandId::kHead, 90);
  bench.drive(6);
  EXPECT_NEAR(client.latest().heading4096, 1024, 12) << "HEAD is in the odometry's frame";
  client.send(CommandId::kDhead, -120);
  bench.drive(5);
  EXPECT_NEAR(client.latest().heading4096, -341, 12);
  const double x = client.latest().xMm, y = client.latest().yMm;
  client.send(CommandId::kMove, -500);
  bench.drive(4);
  EXPECT_NEAR(std::hypot(client.latest().xMm - x, client.latest().yMm - y), 500, 15);
  EXPECT_LT(client.latest().xMm, x) << "backwards";
  client.send(CommandId::kVel2, joined({10, 5}));
  bench.drive(2);
  EXPECT_NEAR(client.latest().leftSpeedMmS, 200, 15);
  EXPECT_NEAR(client.latest().rightSpeedMmS, 100, 15);
  client.send(CommandId::kEStop);
  bench.run(0.4);
  EXPECT_NEAR(client.latest().leftSpeedMmS, 0, 15) << "faster than its deceleration";
}

TEST(ArcosAcceptance, c8MotorsAndSonarsFollowTheirCommandsWithinASecond) {
  ArcosBench bench;
  WireClient& client = bench.connect();
  client.handshake();
  bench.run(0.5);
  EXPECT_FALSE(client.latest().motorsOn()) << "off after connecting";
  client.send(CommandId::kVel, 300);
  bench.run(1);
  EXPECT_NEAR(client.latest().xMm, 0, 1) << "no motion while disabled";
  client.send(CommandId::kEnable, 1);
  EXPECT_TRUE(bench.runUntil([&] { return client.latest().motorsOn(); }, 1));
  client.send(CommandId::kVel, 300);
  bench.run(1.5);
  client.send(CommandId::kEnable, 0);
  EXPECT_TRUE(bench.runUntil([&] { return !client.latest().motorsOn(); }, 1));
  bench.run(1);
  const int x = client.latest().xMm;
  bench.run(0.7);
  EXPECT_NEAR(client.latest().xMm, x, 2);
  client.send(CommandId::kSonar, 0);
  EXPECT_TRUE(
      bench.runUntil([&] { return (client.latest().flags & StandardInformation::kAnySonarOn) == 0; }, 1));
  client.send(CommandId::kSonar, 1);
  EXPECT_TRUE(
      bench.runUntil([&] { return (client.latest().flags & StandardInformation::kSonarArray1On) != 0; }, 1));
}

TEST(ArcosAcceptance, c14AfterCloseANewHandshakeWorksOnTheSameConnection) {
  ArcosBench bench;
  WireClient& client = bench.connect();
  for (int i = 0; i < 3; ++i) {
    client.send(CommandId::kClose);  // as some clients do before they begin
    client.handshake();
    client.send(CommandId::kEnable, 1);
    client.send(CommandId::kSetV, 100);
    client.send(CommandId::kVel, 300);
    bench.run(1.5);
    EXPECT_NEAR(client.latest().leftSpeedMmS, 100, 10);
    client.send(CommandId::kClose, 1);
    bench.run(0.1);
    client.forget();
    bench.run(1);
    EXPECT_THAT(client.received, IsEmpty());
    EXPECT_FALSE(bench.world().pioneers()[0]->session().motion().motorsOn());
    EXPECT_EQ(bench.world().pioneers()[0]->session().motion().parameters().speed, 0.75)
        << "parameters are the defaults";
  }
}

TEST(ArcosAcceptance, c15ASecondClientIsClosedAtOnceAndDoesNotCorruptTheFirst) {
  ArcosBench bench;
  WireClient& client = bench.connect();
  client.handshake();
  bench.run(0.5);
  const auto second = bench.knock();
  second->send(CommandId::kSync0);
  second->send(CommandId::kEnable, 1);
  client.forget();
  bench.drive(2);
  for (int i = 0; i < 200 && !second->closed(); ++i) {
    bench.settle();
    second->receive(bench.now());
  }
  EXPECT_TRUE(second->closed());
  EXPECT_THAT(second->received, IsEmpty());
  EXPECT_EQ(client.information().size(), 20U);
  EXPECT_FALSE(client.latest().motorsOn());
  EXPECT_EQ(bench.simulation().ports().ports().statistics(0).refused, 1U);
}

TEST(ArcosAcceptance, c16TheSimulatorsOwnCommands) {
  ArcosBench bench;
  WireClient& client = bench.connect();
  client.handshake();
  client.send(Packet{224, {0, 0xE8, 3, 0, 0, 0xD0, 7, 0, 0, 90, 0, 0, 0}});  // 1000, 2000, 90
  bench.run(0.1);
  client.send(CommandId::kSimStat, 1);
  ASSERT_TRUE(bench.runUntil([&] { return !client.of(SimulatorStatus::kId).empty(); }, kNoTime));
  auto status = decode<SimulatorStatus>(client.of(SimulatorStatus::kId)[0]);
  ASSERT_TRUE(status);
  EXPECT_NEAR(status->xMm, 1000, 2);
  EXPECT_NEAR(status->yMm, 2000, 2);
  EXPECT_NEAR(status->headingDeg, 90, 1);
  EXPECT_EQ(client.latest().xMm, 0) << "the odometry stays";
  client.forget();
  client.send(CommandId::kSimStat, 2);
  bench.run(1);
  EXPECT_THAT(client.of(SimulatorStatus::kId), SizeIs(10));
  client.send(CommandId::kSimStat, 0);
  client.send(CommandId::kSimReset);
  bench.run(0.2);
  const auto pose = bench.world().simulation().modelPose("p3at1");
  EXPECT_NEAR(pose->translation().x(), 0, 0.01);
  client.send(CommandId::kSimMessage, "hello\x1B[2J");
  client.send(Packet{236, {0x2B, 6, 0}});
  ASSERT_TRUE(bench.runUntil([&] { return !client.of(SimulatorInfo::kId).empty(); }, kNoTime));
  EXPECT_EQ(decode<SimulatorInfo>(client.of(SimulatorInfo::kId)[0])->application, "RobotControl");
  EXPECT_THAT(bench.reported, testing::Contains("p3at1: hello?[2J")) << "without what disturbs a terminal";
  client.send(Packet{236, {0x2B, 1, 0, 9, 0, 'w', 'o', 'r', 'l', 'd', '.', 's', 'd', 'f'}});
  ASSERT_TRUE(bench.runUntil([&] { return !client.of(MapChanged::kId).empty(); }, kNoTime));
  EXPECT_EQ(decode<MapChanged>(client.of(MapChanged::kId)[0])->loaded, 1);
  client.send(CommandId::kSimExit, 3);
  ASSERT_TRUE(bench.runUntil([&] { return bench.simulation().ports().exitRequest().has_value(); }, kNoTime));
  EXPECT_EQ(bench.simulation().ports().exitRequest(), 3);
}

TEST(ArcosAcceptance, aClientThatWritesWithoutEndIsShownInPart) {
  ArcosBench bench;
  WireClient& client = bench.connect();
  client.handshake();
  for (int i = 0; i < 1000; ++i) {
    client.send(CommandId::kSimMessage, "again");
    client.send(Packet{224, {0x2B, 0xFF, 0xFF, 0xFF, 0x7F, 0, 0, 0, 0, 0, 0, 0, 0}});  // 2000 km away
    if (i % 20 == 19) bench.step();
  }
  bench.run(0.5);
  const auto shown = bench.reported.size();
  EXPECT_LE(shown, 60U);
  EXPECT_THAT(bench.reported, testing::Contains("p3at1: again"));
  EXPECT_GT(bench.simulation().ports().suppressedTexts(0), 900U);
}

TEST(ArcosAcceptance, c17EncodersInputsGyroscopeAndInertialUnit) {
  ArcosBench bench;
  WireClient& client = bench.connect();
  client.handshake();
  client.send(CommandId::kEnable, 1);
  client.send(CommandId::kRvel, 20);
  bench.drive(2);
  client.forget();
  client.send(CommandId::kEncoder, 1);
  client.send(CommandId::kIoRequest, 2);
  client.send(CommandId::kGyro, 2);
  client.send(CommandId::kImuRequest, 2);
  client.send(CommandId::kBatteryInfo, 1);
  bench.drive(1);
  EXPECT_THAT(client.of(EncoderPacket::kId), SizeIs(1));
  EXPECT_THAT(client.of(IoPacket::kId), SizeIs(10));
  EXPECT_THAT(client.of(BatteryPacket::kId), SizeIs(1));
  ASSERT_THAT(client.of(GyroPacket::kId), SizeIs(10));
  const auto encoders = decode<EncoderPacket>(client.of(EncoderPacket::kId)[0]);
  EXPECT_LT(encoders->leftTicks, -1000);
  EXPECT_GT(encoders->rightTicks, 1000);
  const auto gyro = decode<GyroPacket>(client.of(GyroPacket::kId).back());
  ASSERT_FALSE(gyro->readings.empty());
  EXPECT_NEAR((512.0 - gyro->readings[0].rate) * 5 / 1023 * 300 / 2.5 * 1.626, 20, 4);
  ASSERT_THAT(client.of(ImuPacket::kId), SizeIs(10));
  EXPECT_NEAR(decode<ImuPacket>(client.of(ImuPacket::kId).back())->readings.at(0).gyro.at(0) * 0.01832, 20,
              4);
}

TEST(ArcosAcceptance, c18NothingForbiddenOrTooLongGoesOut) {
  ArcosBench bench;
  WireClient& client = bench.connect();
  client.handshake();
  Random random(18);
  for (int i = 0; i < 1500; ++i) {
    const auto id = static_cast<std::uint8_t>(random.bits() % 256);
    if (id == 239 || id == 2) continue;
    Bytes data(random.bits() % 30);
    for (auto& byte : data) byte = static_cast<std::uint8_t>(random.bits());
    if (!data.empty()) data[0] = std::array<std::uint8_t, 3>{0x3B, 0x1B, 0x2B}[random.bits() % 3];
    client.send(Packet{id, data});
    if (i % 10 == 0) bench.run(0.1);
  }
  EXPECT_GT(client.received.size(), 100U);
  for (const Packet& packet : client.received) {
    EXPECT_LT(packet.id, 0xFE);
    EXPECT_LE(packet.count(), kMaxSentCount);
  }
}

}  // namespace
}  // namespace app
