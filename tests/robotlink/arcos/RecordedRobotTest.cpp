// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "robotlink/arcos/ClientSession.h"
#include "tests/robotlink/arcos/Recordings.h"

namespace robotlink::arcos {
namespace {

using namespace std::chrono_literals;

struct Replay {
  ClientSession session;
  std::vector<Packet> said;
  std::size_t information = 0;  ///< that the recording has
  std::size_t lastScanParts = 0;
  StandardInformation last;
};

/// What the robot said, at the times when it said it, to a session of ours.
Replay replay(const Conversation& conversation) {
  Replay result;
  Instant now{};
  PacketParser fromRobot;
  PacketParser fromClient;
  const auto turn = [&] {
    result.session.tick(now);
    fromClient.push(result.session.takeOutgoing());
    while (const auto found = fromClient.next()) result.said.push_back(std::get<Packet>(*found));
  };
  result.session.open(now);
  result.session.linkOpened(now);
  for (const Conversation::Event& event : conversation.events) {
    for (; now + 10ms < Instant(event.at); now += 10ms) turn();
    now = std::max(now, Instant(event.at));
    if (event.kind != Conversation::Kind::kPacket || event.direction != Direction::kFromRobot) continue;
    fromRobot.push(event.bytes);
    while (const auto found = fromRobot.next()) {
      const auto& packet = std::get<Packet>(*found);
      if (const auto sip = decode<StandardInformation>(packet)) {
        ++result.information;
        result.last = *sip;
      }
      if (const auto laser = decode<LaserPacket>(packet);
          laser && laser->first + laser->readings.size() >= laser->total) {
        ++result.lastScanParts;
      }
      result.session.take(packet, now);
    }
    turn();
  }
  return result;
}

/// The parameter is the source of the conversations.
class RecordedRobotTest : public testing::TestWithParam<std::string> {
 protected:
  bool real() const { return GetParam() == "real"; }
};

TEST_P(RecordedRobotTest, theSessionConnectsToEveryRobot) {
  const auto files = conversations(GetParam());
  if (files.empty()) GTEST_SKIP() << "there is no ../shared/data/arcos/wire with recorded conversations";
  for (const auto& file : files) {
    const auto conversation = readConversation(textOf(file), file.string());
    ASSERT_TRUE(conversation) << conversation.error().describe();
    const Replay found = replay(*conversation);
    const ClientSession& session = found.session;
    EXPECT_TRUE(session.isConnected()) << file << ": " << session.describe();
    EXPECT_EQ(session.statistics().connections, 1U);
    EXPECT_EQ(session.statistics().losses, 0U);
    EXPECT_EQ(session.statistics().undecodable, 0U);
    EXPECT_EQ(session.statistics().information, found.information) << file;
    EXPECT_GT(found.information, 20U);
    EXPECT_EQ(*session.information(), found.last);
    EXPECT_EQ(session.identity()->name, real() ? "AMRISim" : "Handmade");
    EXPECT_EQ(session.configuration()->transVelMaxMmS, real() ? 3000 : 700);
    EXPECT_EQ(session.statistics().scans, found.lastScanParts);
    EXPECT_EQ(session.statistics().incompleteScans, 0U);
    const std::vector<Packet> beginning = {{0, {}}, {1, {}}, {2, {}}, {1, {0x3B, 1, 0}}, {18, {0x3B, 1, 0}}};
    ASSERT_GT(found.said.size(), beginning.size());
    EXPECT_TRUE(std::equal(beginning.begin(), beginning.end(), found.said.begin()));
  }
}

TEST_P(RecordedRobotTest, scansAreWholeAndInOrder) {
  const auto scans = conversation(GetParam(), real() ? "laserConnect" : "scans");
  if (!scans) GTEST_SKIP() << "there is no ../shared/data/arcos/wire/laserConnect.wire.xz";
  const Replay found = replay(*scans);
  ASSERT_TRUE(found.session.laserScan());
  EXPECT_EQ(found.session.statistics().scans, real() ? 285U : 11U);
  const auto& ranges = found.session.laserScan()->rangesMm;
  EXPECT_EQ(ranges.size(), 181U);
  // The closest wall is at 514 mm, or straight ahead.
  EXPECT_EQ(*std::min_element(ranges.begin(), ranges.end()) / 100, real() ? 5 : 8);
  if (!real()) {
    EXPECT_EQ(ranges[90], 800);
  }
}

INSTANTIATE_TEST_SUITE_P(Conversations, RecordedRobotTest, testing::ValuesIn(kConversationSources),
                         [](const auto& source) { return source.param; });

}  // namespace
}  // namespace robotlink::arcos
