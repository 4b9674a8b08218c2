// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/robotlink/arcos/Recordings.h"

#include <gtest/gtest.h>

#include "robotlink/arcos/codec/Command.h"
#include "robotlink/arcos/codec/PacketDescription.h"
#include "robotlink/arcos/codec/PacketParser.h"
#include "robotlink/arcos/codec/ServerPackets.h"

namespace robotlink::arcos {
namespace {

/// The parameter is the source of the conversations.
class RecordingsTest : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    if (files_.empty()) GTEST_SKIP() << "there is no ../shared/data/arcos/wire with recorded conversations";
  }
  bool real() const { return GetParam() == "real"; }
  const std::vector<std::filesystem::path> files_ = conversations(GetParam());
};

/// The same packet, by way of what it says.
tl::expected<Packet, Error> rewritten(const Packet& packet, Direction direction) {
  if (direction == Direction::kFromClient) {
    return toCommand(packet).map([](const Command& command) { return toPacket(command); });
  }
  return decodeServerPacket(packet).map([](const ServerPacket& typed) { return toPacket(typed); });
}

TEST_P(RecordingsTest, everyPacketIsReadAndWrittenBackByteForByte) {
  EXPECT_EQ(files_.size(), real() ? 6U : 4U);
  std::size_t packets = 0;
  for (const auto& file : files_) {
    const auto conversation = readConversation(textOf(file), file.string());
    ASSERT_TRUE(conversation) << conversation.error().describe();
    for (const Conversation::Event& event : conversation->events) {
      if (event.kind != Conversation::Kind::kPacket) continue;
      PacketParser parser;
      parser.push(event.bytes);
      const auto found = parser.next();
      ASSERT_TRUE(found && std::holds_alternative<Packet>(*found)) << toHex(event.bytes);
      const auto& packet = std::get<Packet>(*found);
      const auto back = rewritten(packet, event.direction);
      ASSERT_TRUE(back) << back.error().describe();
      EXPECT_EQ(toHex(encode(*back)), toHex(event.bytes));
      EXPECT_FALSE(parser.isPartial());
      ++packets;
    }
  }
  EXPECT_EQ(packets, real() ? 3326U : 338U);
}

TEST_P(RecordingsTest, everyPacketHasALayout) {
  for (const auto& file : files_) {
    const auto conversation = readConversation(textOf(file), file.string());
    ASSERT_TRUE(conversation) << conversation.error().describe();
    for (const Conversation::Event& event : conversation->events) {
      if (event.kind != Conversation::Kind::kPacket) continue;
      const Packet packet{event.bytes[3], Bytes(event.bytes.begin() + 4, event.bytes.end() - 2)};
      const PacketDescription description = describe(packet, event.direction);
      EXPECT_EQ(description.problem, "");
      EXPECT_EQ(description.fields.empty(), packet.data.empty()) << description.line();
      for (const PacketField& field : description.fields)
        EXPECT_NE(field.name, "bytes") << description.line();
    }
  }
}

TEST_P(RecordingsTest, filesAreWrittenBackByteForByte) {
  for (const auto& file : files_) {
    const std::string text = textOf(file);
    const auto conversation = readConversation(text, file.string());
    ASSERT_TRUE(conversation) << conversation.error().describe();
    EXPECT_TRUE(writeConversation(*conversation) == text) << file;
  }
}

TEST_P(RecordingsTest, allOfADirectionAsOneStreamGivesTheSamePackets) {
  for (const auto& file : files_) {
    const auto conversation = readConversation(textOf(file), file.string());
    ASSERT_TRUE(conversation);
    Bytes stream;
    std::size_t sent = 0;
    for (const Conversation::Event& event : conversation->events) {
      if (event.kind != Conversation::Kind::kPacket || event.direction != Direction::kFromRobot) continue;
      stream.insert(stream.end(), event.bytes.begin(), event.bytes.end());
      ++sent;
    }
    PacketParser parser;
    for (std::size_t at = 0; at < stream.size(); at += 7) {
      parser.push(std::span(stream).subspan(at, std::min<std::size_t>(7, stream.size() - at)));
      while (const auto found = parser.next()) EXPECT_TRUE(std::holds_alternative<Packet>(*found));
    }
    EXPECT_EQ(parser.counters(), (PacketParser::Counters{sent, 0, 0}));
  }
}

TEST_P(RecordingsTest, theConfigurationSaysWhatIsKnownOfTheRobot) {
  const auto conversation = readConversation(textOf(files_.front()), "");
  ASSERT_TRUE(conversation);
  for (const Conversation::Event& event : conversation->events) {
    if (event.bytes.size() < 6 || event.bytes[3] != Configuration::kId) continue;
    const auto found =
        decode<Configuration>({Configuration::kId, Bytes(event.bytes.begin() + 4, event.bytes.end() - 2)});
    ASSERT_TRUE(found);
    EXPECT_EQ(found->fieldCount, Configuration::kUsualFields);
    EXPECT_TRUE(found->rest.empty());
    EXPECT_EQ(found->subtype, "p3at-sh");
    EXPECT_EQ(found->serialNumber, real() ? "SIM" : "HAND");
    EXPECT_EQ(found->name, real() ? "AMRISim" : "Handmade");
    EXPECT_EQ(found->rotVelTopDegS, real() ? 9999 : 360);
    EXPECT_EQ(found->pwmMax, real() ? 400 : 500);
    EXPECT_EQ(found->sipCycleMs, 100);
    EXPECT_EQ(found->watchdogMs, 2000);
    EXPECT_EQ(found->rotVelMaxDegS, real() ? 150 : 100);
    EXPECT_EQ(found->transVelMaxMmS, real() ? 3000 : 700);
    EXPECT_EQ(found->transDecelMmS2, 300);
    EXPECT_EQ(found->autoBaud, real() ? 2 : 0);
    EXPECT_EQ(found->version, real() ? "S.0" : "2.1");
    return;
  }
  FAIL() << "there is no configuration in " << files_.front();
}

INSTANTIATE_TEST_SUITE_P(Conversations, RecordingsTest, testing::ValuesIn(kConversationSources),
                         [](const auto& source) { return source.param; });

}  // namespace
}  // namespace robotlink::arcos
