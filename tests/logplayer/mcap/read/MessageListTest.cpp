// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/mcap/read/MessageList.h"

#include <gmock/gmock.h>

#include "tests/logplayer/mcap/BuiltFile.h"

using namespace logplayer::mcap;
using namespace logplayer::mcap::test;
using testing::ElementsAre;
using testing::IsEmpty;

namespace {

using Entry = MessageList::Entry;

/// A section with messages of the channels 1 and 2 from 10 to 20 ns.
Section sectionOf12() {
  Section section;
  section.info.start = at(10);
  section.info.end = at(20);
  section.info.uncompressedBytes = 100;
  section.channels = {1, 2};
  return section;
}

std::optional<MessageList> listOf(const std::vector<MessageIndex>& indexes) {
  Buffer bytes;
  for (const MessageIndex& index : indexes) encode(bytes, index);
  return MessageList::fromIndexes(bytes, sectionOf12());
}

TEST(MessageList, messagesAreSortedByTimeWithinEachChannel) {
  const MessageList list =
      MessageList::fromRecords(recordsOf({{2, 0, 30, ""}, {1, 1, 20, ""}, {2, 2, 10, ""}, {2, 3, 10, ""}}));
  constexpr std::uint32_t kBytes = kMessageHeadBytes;
  EXPECT_EQ(list.messages(), 4U);
  EXPECT_THAT(list.of(1), ElementsAre(Entry{at(20), kBytes}));
  EXPECT_THAT(list.of(2), ElementsAre(Entry{at(10), 2 * kBytes}, Entry{at(10), 3 * kBytes}, Entry{at(30), 0}))
      << "equal times in the order of the file";
  EXPECT_THAT(list.of(3), IsEmpty());
  EXPECT_THAT(list.of(0), IsEmpty());
}

TEST(MessageList, messageIndexesListTheSameAsTheRecords) {
  const MessageList found =
      MessageList::fromRecords(recordsOf({{1, 0, 10, ""}, {2, 0, 15, ""}, {1, 1, 20, ""}}));
  constexpr std::uint32_t kBytes = kMessageHeadBytes;
  const auto stated = listOf({{2, {{15, kBytes}}}, {1, {{20, 2 * kBytes}, {10, 0}}}});
  ASSERT_TRUE(stated);
  EXPECT_TRUE(*stated == found);
  EXPECT_FALSE(*listOf({{2, {{15, kBytes}}}, {1, {{20, 2 * kBytes}, {11, 0}}}}) == found);
  EXPECT_FALSE(MessageList() == found);
}

TEST(MessageList, indexesThatContradictTheSectionAreRefused) {
  EXPECT_TRUE(listOf({{1, {{10, 0}}}, {2, {{20, 99}}}}));
  EXPECT_FALSE(listOf({{1, {{9, 0}}}, {2, {{20, 99}}}})) << "before its start";
  EXPECT_FALSE(listOf({{1, {{10, 0}}}, {2, {{21, 99}}}})) << "after its end";
  EXPECT_FALSE(listOf({{1, {{10, 0}}}, {2, {{20, 100}}}})) << "behind its records";
  EXPECT_FALSE(listOf({{1, {{10, 0}}}})) << "a channel is missing";
  EXPECT_FALSE(listOf({{1, {{10, 0}}}, {2, {{20, 9}}}, {3, {{20, 50}}}})) << "one channel too many";
}

TEST(MessageList, indexesThatContradictThemselvesAreRefused) {
  EXPECT_FALSE(listOf({{1, {{10, 0}, {10, 0}}}, {2, {{20, 9}}}})) << "a message twice";
  EXPECT_FALSE(listOf({{1, {{10, 0}}}, {1, {{11, 5}}}, {2, {{20, 9}}}})) << "a channel twice";
  Buffer bytes;
  encode(bytes, MessageIndex{1, {{10, 0}}});
  encode(bytes, MessageIndex{2, {{20, 9}, {20, 50}}});
  const std::size_t size = bytes.size() - 2 * 16 - 4;
  Buffer shorter = bytes;
  storeNumber(shorter.data() + size, std::uint32_t{16});
  EXPECT_FALSE(MessageList::fromIndexes(shorter, sectionOf12())) << "a further entry would fit";
  storeNumber(shorter.data() + size, std::uint32_t{17});
  EXPECT_FALSE(MessageList::fromIndexes(shorter, sectionOf12())) << "no whole entries";
  bytes.pop_back();
  EXPECT_FALSE(MessageList::fromIndexes(bytes, sectionOf12())) << "the record breaks off";
}

}  // namespace
