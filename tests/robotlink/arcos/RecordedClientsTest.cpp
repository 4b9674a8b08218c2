// SPDX-License-Identifier: GPL-3.0-or-later
// The client halves of conversations, said to our robot at the times at which they were recorded, or that
// were made up.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "robotlink/arcos/codec/PacketParser.h"
#include "tests/robotlink/arcos/IdealRobot.h"
#include "tests/robotlink/arcos/Recordings.h"

namespace robotlink::arcos {
namespace {

using testing::Ge;
using testing::SizeIs;
using Kind = Conversation::Kind;

class RecordedClientsTest : public testing::Test {
 protected:
  IdealRobot robot;
  /// Information packets while it was open, and when they came.
  std::vector<StandardInformation> information;
  std::vector<Instant> informedAt;

  void TearDown() override {
    for (const Packet& packet : robot.received) {
      EXPECT_LE(packet.count(), kMaxSentCount);
      EXPECT_LT(packet.id, 0xFE);
    }
    EXPECT_EQ(robot.session.droppedPackets(), 0U);
  }

  /// False if there is no such conversation.
  bool play(const std::string& source, const std::string& name) {
    const auto found = conversation(source, name);
    if (found) play(*found);
    return found.has_value();
  }

  std::vector<int> sequence(std::size_t count) const {
    std::vector<int> ids;
    for (std::size_t i = 0; i < std::min(count, robot.received.size()); ++i)
      ids.push_back(robot.received[i].id);
    return ids;
  }
  /// The longest time between two information packets.
  Duration longestGap() const {
    Duration longest{};
    for (std::size_t i = 1; i < informedAt.size(); ++i)
      longest = std::max(longest, informedAt[i] - informedAt[i - 1]);
    return longest;
  }

 private:
  void play(const Conversation& conversation) {
    for (const Conversation::Event& event : conversation.events) {
      const Instant begin;
      while (robot.now < begin + event.at) robot.step();
      if (event.kind == Kind::kClosed) robot.session.clientGone(robot.now);
      if (event.kind != Kind::kPacket || event.direction != Direction::kFromClient) continue;
      robot.send({event.bytes[3], Bytes(event.bytes.begin() + 4, event.bytes.end() - 2)});
    }
    for (std::size_t i = 0; i < robot.received.size(); ++i) {
      if ((robot.received[i].id & 0xF0) != 0x30) continue;
      information.push_back(*decode<StandardInformation>(robot.received[i]));
      informedAt.push_back(robot.receivedAt[i]);
    }
  }
};

#define PLAY(name) \
  if (!play("real", name)) GTEST_SKIP() << "there is no recording " << name << " in ../shared/data/arcos/wire"

TEST_F(RecordedClientsTest, simpleConnectGetsWhatItWaitsForAndNothingAfterItsClose) {
  PLAY("simpleConnect");
  EXPECT_THAT(sequence(4), testing::ElementsAre(0, 1, 2, Configuration::kId));
  EXPECT_EQ(longestGap(), std::chrono::milliseconds(100));
  EXPECT_TRUE(information[5].motorsOn());
  EXPECT_EQ(robot.session.state(), ServerSession::State::kWaiting);
  EXPECT_FALSE(robot.wheels.command.motorsOn);
  // OPEN came at 477.6 ms, CLOSE at 3634.4 ms.
  EXPECT_NEAR(static_cast<double>(information.size()), 31, 1);
}

TEST_F(RecordedClientsTest, simpleMotionCommandsDriveAsFarAsTheyDidThere) {
  PLAY("simpleMotionCommands");
  // There: 1250 mm straight; then 568 units of 4096 to the left and back; then 150 mm/s for five seconds.
  double farthest = 0;
  int leftmost = 0;
  for (const auto& sip : information) {
    farthest = std::max<double>(farthest, sip.xMm);
    leftmost = std::max<int>(leftmost, sip.heading4096);
  }
  EXPECT_NEAR(information[120].xMm, 1250, 30);
  EXPECT_NEAR(leftmost, 560, 30);
  const auto& last = information.back();
  EXPECT_NEAR(last.heading4096, -568, 30);
  EXPECT_NEAR(last.xMm, 1703, 60);
  EXPECT_NEAR(last.yMm, -540, 60);
  EXPECT_LE(longestGap(), std::chrono::milliseconds(104));
}

TEST_F(RecordedClientsTest, gotoActionExampleIsObeyedInItsOdometry) {
  PLAY("gotoActionExample");
  EXPECT_TRUE(information[30].motorsOn());
  // It turns to headings that it took from another robot's odometry, and ours goes where it says.
  double most = 0;
  for (const auto& sip : information) most = std::max(most, std::hypot(sip.xMm, sip.yMm));
  EXPECT_GT(most, 1500);
  EXPECT_LE(longestGap(), std::chrono::milliseconds(104));
}

TEST_F(RecordedClientsTest, laserConnectGetsItsScans) {
  PLAY("laserConnect");
  const auto parts = robot.of(LaserPacket::kExtendedId);
  ASSERT_THAT(parts, SizeIs(Ge(60U)));
  EXPECT_EQ(parts.size() % 6, 0U);
  EXPECT_EQ(decode<LaserPacket>(parts[0])->total, 181);
  EXPECT_GT(robot.scans, 10);
  EXPECT_LE(robot.scans, static_cast<int>(information.size()));
}

TEST_F(RecordedClientsTest, sonarTestHearsAllSixteen) {
  PLAY("sonarTest");
  EXPECT_THAT(robot.shots, SizeIs(16));
  EXPECT_TRUE(information.back().sonarOn());
}

TEST_F(RecordedClientsTest, robotConnectionCallbacksIsServedAndClosed) {
  PLAY("robotConnectionCallbacks");
  EXPECT_FALSE(information.back().sonarOn()) << "it switches them off";
  EXPECT_EQ(robot.session.state(), ServerSession::State::kWaiting);
}

TEST_F(RecordedClientsTest, aMadeClientGetsWhatItWaitsForAndNothingAfterItsClose) {
  ASSERT_TRUE(play("made", "connect"));
  EXPECT_THAT(sequence(4), testing::ElementsAre(0, 1, 2, Configuration::kId));
  EXPECT_EQ(longestGap(), std::chrono::milliseconds(100));
  EXPECT_TRUE(information[5].motorsOn());
  EXPECT_EQ(robot.session.state(), ServerSession::State::kWaiting);
  EXPECT_FALSE(robot.wheels.command.motorsOn);
  // OPEN came at 300 ms, CLOSE at 3 s.
  EXPECT_NEAR(static_cast<double>(information.size()), 26, 1);
}

TEST_F(RecordedClientsTest, aMadeClientDrivesAsFarAsItAsksFor) {
  ASSERT_TRUE(play("made", "drive"));
  ASSERT_GT(information.size(), 100U);
  EXPECT_TRUE(information[30].motorsOn());
  // A meter straight on, an eighth of a turn, then 0.2 m/s for two seconds.
  EXPECT_NEAR(information[58].xMm, 1000, 30);
  EXPECT_NEAR(information[58].yMm, 0, 5);
  const auto& last = information.back();
  EXPECT_NEAR(last.heading4096, 512, 30);
  EXPECT_NEAR(last.xMm, 1280, 40);
  EXPECT_NEAR(last.yMm, 280, 40);
  EXPECT_LE(longestGap(), std::chrono::milliseconds(104));
}

TEST_F(RecordedClientsTest, aMadeClientGetsItsScans) {
  ASSERT_TRUE(play("made", "scans"));
  const auto parts = robot.of(LaserPacket::kExtendedId);
  ASSERT_THAT(parts, SizeIs(Ge(60U)));
  EXPECT_EQ(parts.size() % 6, 0U);
  EXPECT_EQ(decode<LaserPacket>(parts[0])->total, 181);
  EXPECT_GT(robot.scans, 10);
  EXPECT_LE(robot.scans, static_cast<int>(information.size()));
}

TEST_F(RecordedClientsTest, aMadeClientHearsAllSonarsUntilItSwitchesThemOff) {
  ASSERT_TRUE(play("made", "sonars"));
  EXPECT_THAT(robot.shots, SizeIs(16));
  EXPECT_TRUE(information[15].sonarOn());
  EXPECT_FALSE(information.back().sonarOn());
  EXPECT_EQ(robot.session.state(), ServerSession::State::kWaiting);
}

}  // namespace
}  // namespace robotlink::arcos
