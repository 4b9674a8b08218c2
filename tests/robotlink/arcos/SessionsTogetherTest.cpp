// SPDX-License-Identifier: GPL-3.0-or-later
// A client's session and a robot's, with good and bad lines between them and no socket.
#include <gtest/gtest.h>

#include "robotlink/arcos/ClientSession.h"
#include "tests/robotlink/arcos/IdealRobot.h"
#include "tests/robotlink/arcos/UnreliableLine.h"

namespace robotlink::arcos {
namespace {

using namespace std::chrono_literals;

class SessionsTogether {
 public:
  explicit SessionsTogether(std::uint64_t seed = 1) : up(seed), down(seed + 1000) {}

  void run(Duration duration) {
    for (const Instant end = robot.now + duration; robot.now < end;) step();
  }
  /// Until it is connected; false if that takes longer than `limit`.
  bool connects(Duration limit) {
    client.open(robot.now);
    for (const Instant end = robot.now + limit; robot.now < end && !client.isConnected();) step();
    return client.isConnected();
  }
  void drive(int speedMmS, Duration duration) {
    for (Duration t{}; t < duration; t += 100ms) {
      static_cast<void>(client.send(command(CommandId::kVel, speedMmS), robot.now));
      run(100ms);
    }
  }
  void faults(const UnreliableLine::Faults& faults) { up.faults = down.faults = faults; }
  void cut(bool isCut) { up.cut = down.cut = isCut; }

  IdealRobot robot;
  ClientSession client;
  UnreliableLine up, down;
  LineEnd atRobot, atClient;

 private:
  void step() {
    robot.step();
    atRobot.take(up.read(robot.now), robot.now, [&](const PacketParser::Found& found) {
      if (const auto* packet = std::get_if<Packet>(&found)) robot.send(*packet);
    });
    for (const Packet& packet : robot.received) down.write(packet, robot.now);
    robot.forget();
    if (client.state() == ClientSession::State::kWaitingForLink) client.linkOpened(robot.now);
    atClient.take(down.read(robot.now), robot.now,
                  [&](const PacketParser::Found& found) { client.take(found, robot.now); });
    client.tick(robot.now);
    up.write(client.takeOutgoing(), robot.now);
  }
};

TEST(SessionsTogetherTest, theyConnectDriveAndPart) {
  SessionsTogether both;
  ASSERT_TRUE(both.connects(1s)) << both.client.describe();
  EXPECT_EQ(both.client.identity()->subclass, "p3at-sh");
  EXPECT_EQ(both.client.configuration()->serialNumber, "SIM");
  const auto before = both.client.statistics().information;
  both.run(10s);
  EXPECT_NEAR(static_cast<double>(both.client.statistics().information - before), 100, 1);
  EXPECT_FALSE(both.robot.session.starved());

  ASSERT_TRUE(both.client.send(command(CommandId::kEnable, 1), both.robot.now));
  both.drive(200, 5s);
  EXPECT_GT(both.client.information()->xMm, 500);
  EXPECT_TRUE(both.client.information()->motorsOn());
  EXPECT_LE(both.client.statistics().longestGap, 110ms);
  EXPECT_EQ(both.atClient.parser.counters().skippedBytes, 0U);

  both.client.close(both.robot.now);
  both.run(1s);
  EXPECT_EQ(both.robot.session.state(), ServerSession::State::kWaiting);
  EXPECT_FALSE(both.robot.session.motion().motorsOn());
  // And again on the same line.
  EXPECT_TRUE(both.connects(1s)) << both.client.describe();
}

TEST(SessionsTogetherTest, aLaserScansWholly) {
  SessionsTogether both;
  ASSERT_TRUE(both.connects(1s));
  ASSERT_TRUE(both.client.send(command(CommandId::kSimLaserEnable, 2), both.robot.now));
  both.run(2s);
  EXPECT_GE(both.client.statistics().scans, 18U);
  EXPECT_EQ(both.client.statistics().incompleteScans, 0U);
  ASSERT_TRUE(both.client.laserScan());
  EXPECT_EQ(both.client.laserScan()->rangesMm, std::vector<std::uint16_t>(181, 7000));
}

TEST(SessionsTogetherTest, aBadLineIsEndured) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SessionsTogether both(seed);
    both.faults({0.15, 0.05, 0.05, 0.1, 0.05});
    EXPECT_TRUE(both.connects(30s)) << "seed " << seed << ": " << both.client.describe();
    both.drive(100, 20s);
    EXPECT_TRUE(both.client.isConnected()) << "seed " << seed << ": " << both.client.describe();
    EXPECT_EQ(both.client.statistics().losses, 0U);
    EXPECT_EQ(both.client.statistics().undecodable, 0U);
    EXPECT_GT(both.client.statistics().information, 100U);
    EXPECT_GT(both.atClient.parser.counters().skippedBytes, 0U);
  }
}

TEST(SessionsTogetherTest, evenTheWorstLineLeavesNothingBehind) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SessionsTogether both(seed);
    both.faults({0.5, 0.2, 0.2, 0.3, 0.3});
    both.client.open(both.robot.now);
    both.drive(100, 40s);
    both.faults({});
    EXPECT_TRUE(both.connects(40s)) << "seed " << seed << ": " << both.client.describe();
    both.run(2s);
    EXPECT_TRUE(both.client.isConnected());
    EXPECT_TRUE(both.client.configuration());
  }
}

TEST(SessionsTogetherTest, aShortSilenceStopsTheRobotAndLosesNothing) {
  SessionsTogether both;
  ASSERT_TRUE(both.connects(1s));
  ASSERT_TRUE(both.client.send(command(CommandId::kEnable, 1), both.robot.now));
  both.drive(200, 2s);
  both.cut(true);
  both.run(5s);
  EXPECT_TRUE(both.robot.session.starved());
  EXPECT_EQ(both.robot.sensing.leftSpeed, 0);
  EXPECT_TRUE(both.client.isConnected());
  EXPECT_GE(both.client.statistics().longestGap, 4900ms);
  both.cut(false);
  both.run(1s);
  EXPECT_FALSE(both.robot.session.starved());
  EXPECT_TRUE(both.client.isConnected());
  EXPECT_EQ(both.client.statistics().losses, 0U);
}

TEST(SessionsTogetherTest, aLongSilenceIsALossAndTheRobotIsFoundAgain) {
  SessionsTogether both;
  ASSERT_TRUE(both.connects(1s));
  both.cut(true);
  both.run(9s);
  EXPECT_FALSE(both.client.isConnected());
  EXPECT_EQ(both.client.statistics().losses, 1U);
  both.run(20s);
  both.cut(false);
  // The robot goes on sending as if nothing had been: it must be sent CLOSE first.
  EXPECT_EQ(both.robot.session.state(), ServerSession::State::kOpen);
  EXPECT_TRUE(both.connects(40s)) << both.client.describe();
  EXPECT_EQ(both.client.statistics().connections, 2U);
}

TEST(SessionsTogetherTest, aClientFindsTheRobotWhereverAnotherLeftIt) {
  for (int left = 0; left <= 4; ++left) {
    SessionsTogether both;
    const CommandId said[] = {CommandId::kSync0, CommandId::kSync1, CommandId::kSync2, CommandId::kOpen};
    for (int i = 0; i < left; ++i) both.robot.send(said[i]);
    both.robot.forget();
    EXPECT_TRUE(both.connects(6s)) << "after " << left << " packets: " << both.client.describe();
  }
}

TEST(SessionsTogetherTest, aRobotThatWasTurnedOffAndOnIsConnectedAnew) {
  SessionsTogether both;
  ASSERT_TRUE(both.connects(1s));
  both.robot.session.clientGone(both.robot.now);
  both.run(9s);
  EXPECT_FALSE(both.client.isConnected());
  EXPECT_TRUE(both.connects(5s)) << both.client.describe();
}

}  // namespace
}  // namespace robotlink::arcos
