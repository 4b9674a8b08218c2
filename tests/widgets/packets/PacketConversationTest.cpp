// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/packets/PacketConversation.h"

#include <gtest/gtest.h>

#include "robotlink/arcos/codec/Command.h"
#include "tests/widgets/streams/StoredMessages.h"
#include "widgets/packets/PacketModel.h"

namespace widgets::test {
namespace {

using robotlink::arcos::Conversation;
using Packets = std::vector<std::string>;
using ReplayState = ConversationReplay::State;
using namespace std::chrono_literals;

std::string bytesOf(int id, int argument) {
  const auto bytes = encode(toPacket(robotlink::arcos::Command{static_cast<std::uint8_t>(id), argument}));
  return {bytes.begin(), bytes.end()};
}

PacketEntry packetRow(double time, int id, bool fromRobot = false) {
  return packetEntry(atSeconds(time), fromRobot, bytesOf(id, 1));
}

PacketEntry markerRow(PacketEntry::Kind kind, double time) {
  PacketEntry entry;
  entry.kind = kind;
  entry.time = atSeconds(time);
  return entry;
}

/// Three packets: at once, after 100 ms, and after 1 s.
ClientHalf half() {
  return {{{0ms, "a"}, {100ms, "b"}, {1s, "c"}}, 0};
}

TEST(ConversationOf, aTableWithoutABeginningGetsOne) {
  PacketModel model;
  EXPECT_TRUE(conversationOf(model).events.empty());
  model.append({packetRow(10, 11), packetRow(10.5, 11, true), markerRow(PacketEntry::Kind::kClosed, 12)});
  const auto events = conversationOf(model).events;
  ASSERT_EQ(events.size(), 4U);
  EXPECT_EQ(events[0].kind, Conversation::Kind::kNewConnection);
  EXPECT_EQ(events[1].at, 0ms);
  EXPECT_EQ(events[2].at, 500ms);
  EXPECT_EQ(events[2].direction, robotlink::arcos::Direction::kFromRobot);
  EXPECT_EQ(events[3].kind, Conversation::Kind::kClosed);
  EXPECT_EQ(events[3].at, 2s);
}

TEST(ConversationOf, timesCountFromTheBeginningOfEachConnection) {
  PacketModel model;
  model.append({markerRow(PacketEntry::Kind::kNewConnection, 10), packetRow(11, 11),
                markerRow(PacketEntry::Kind::kNewConnection, 20), packetRow(20.25, 11)});
  const auto events = conversationOf(model).events;
  ASSERT_EQ(events.size(), 4U);
  EXPECT_EQ(events[1].at, 1s);
  EXPECT_EQ(events[3].at, 250ms);
}

TEST(EntriesOf, connectionsFollowEachOtherInTime) {
  PacketModel model;
  model.append({markerRow(PacketEntry::Kind::kNewConnection, 10), packetRow(11, 11),
                markerRow(PacketEntry::Kind::kClosed, 12), markerRow(PacketEntry::Kind::kNewConnection, 60),
                packetRow(60.25, 11, true)});
  const auto entries = entriesOf(conversationOf(model));
  ASSERT_EQ(entries.size(), 5U);
  EXPECT_EQ(entries[1].time, atSeconds(1));
  EXPECT_EQ(entries[2].name, QStringLiteral("connection closed"));
  EXPECT_EQ(entries[3].time, atSeconds(2)) << "nobody waits for the time between";
  EXPECT_EQ(entries[4].time, atSeconds(2.25));
  EXPECT_TRUE(entries[4].fromRobot);
  EXPECT_EQ(entries[4].bytes, bytesOf(11, 1));
}

TEST(ClientHalfOf, whatWouldOpenOrCloseTheConnectionIsLeftOut) {
  PacketModel model;
  model.append({packetRow(1, 1), packetRow(2, 0), packetRow(2.5, 11, true), packetRow(3, 11),
                packetEntry(atSeconds(3.5), false, "no packet"), packetRow(4, 2)});
  const ClientHalf client = clientHalf(model);
  EXPECT_EQ(client.leftOut, 2);
  ASSERT_EQ(client.packets.size(), 3U);
  EXPECT_EQ(client.packets[0].bytes, bytesOf(0, 1));
  EXPECT_EQ(client.packets[0].at, 0ms) << "times count from the first that is sent";
  EXPECT_EQ(client.packets[1].at, 1s);
  EXPECT_EQ(client.packets[2].bytes, "no packet") << "damage is part of what was said";
}

TEST(ConversationReplay, packetsAreDueAtTheirTimes) {
  ConversationReplay replay;
  replay.begin(half(), false);
  EXPECT_EQ(replay.state(), ReplayState::kRunning);
  EXPECT_EQ(replay.tick(atSeconds(50)), Packets{"a"}) << "its time begins with the first tick";
  EXPECT_EQ(replay.tick(atSeconds(50.099)), Packets());
  EXPECT_EQ(replay.tick(atSeconds(50.1)), Packets{"b"});
  for (int i = 1; i <= 8; ++i) EXPECT_EQ(replay.tick(atSeconds(50.1 + 0.1 * i)), Packets());
  EXPECT_EQ(replay.state(), ReplayState::kRunning);
  EXPECT_EQ(replay.tick(atSeconds(51.001)), Packets{"c"});
  EXPECT_EQ(replay.state(), ReplayState::kIdle);
  EXPECT_EQ(replay.done(), 3U);
  EXPECT_EQ(replay.tick(atSeconds(60)), Packets());
}

TEST(ConversationReplay, aPauseBringsNoBurstAndAClockThatIsSetBackNothing) {
  ConversationReplay replay;
  replay.begin(half(), false);
  replay.tick(atSeconds(50));
  EXPECT_EQ(replay.tick(atSeconds(1000)), Packets{"b"}) << "at most 250 ms have passed";
  EXPECT_EQ(replay.tick(atSeconds(5)), Packets());
  EXPECT_EQ(replay.tick(atSeconds(5.5)), Packets()) << "500 ms have";
  EXPECT_EQ(replay.tick(atSeconds(6)), Packets());
  EXPECT_EQ(replay.tick(atSeconds(6.5)), Packets{"c"});
}

TEST(ConversationReplay, stepsDoNotCareAboutTimes) {
  ConversationReplay replay;
  replay.begin(half(), true);
  EXPECT_EQ(replay.tick(atSeconds(50)), Packets());
  EXPECT_EQ(replay.step(), "a");
  EXPECT_EQ(replay.step(), "b");
  EXPECT_EQ(replay.done(), 2U);
  EXPECT_EQ(replay.step(), "c");
  EXPECT_EQ(replay.state(), ReplayState::kIdle);
  EXPECT_EQ(replay.step(), "");
}

TEST(ConversationReplay, fromStepsItGoesOnWithTheNextPacketAtOnce) {
  ConversationReplay replay;
  replay.begin(half(), true);
  replay.step();
  replay.setStepping(false);
  EXPECT_EQ(replay.tick(atSeconds(50)), Packets{"b"});
  EXPECT_EQ(replay.tick(atSeconds(50.2)), Packets());
  replay.setStepping(true);
  EXPECT_EQ(replay.tick(atSeconds(80)), Packets());
  EXPECT_EQ(replay.step(), "c");
}

TEST(ConversationReplay, withoutPacketsOrAfterACancelNothingIsDue) {
  ConversationReplay replay;
  replay.begin({{}, 2}, false);
  EXPECT_EQ(replay.state(), ReplayState::kIdle);
  EXPECT_EQ(replay.leftOut(), 2);
  replay.setStepping(true);
  EXPECT_EQ(replay.state(), ReplayState::kIdle);
  replay.begin(half(), false);
  replay.cancel();
  EXPECT_EQ(replay.tick(atSeconds(1)), Packets());
  replay.begin(half(), false);
  EXPECT_EQ(replay.done(), 0U) << "it starts over";
  EXPECT_EQ(replay.tick(atSeconds(1)), Packets{"a"});
}

}  // namespace
}  // namespace widgets::test
