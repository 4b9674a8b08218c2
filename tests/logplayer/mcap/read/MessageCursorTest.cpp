// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/mcap/read/MessageCursor.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cstring>
#include <random>

#include "tests/logplayer/mcap/TemporaryLog.h"

using namespace logplayer::mcap;
using namespace logplayer::mcap::test;
using testing::IsEmpty;
using testing::SizeIs;

namespace {

const std::vector<std::uint16_t> kAll{1, 2, 3};

class MessageCursorTest : public testing::Test {
 protected:
  /// In chunks of some messages each.
  std::unique_ptr<Reader> written(const std::vector<Expected>& messages, std::size_t inChunk,
                                  Reader::Options options = {}) {
    std::vector<std::size_t> flushes;
    for (std::size_t i = inChunk; i < messages.size(); i += inChunk) flushes.push_back(i);
    std::filesystem::remove(file_);
    writeLog(file_, messages, {}, flushes);
    return test::open(file_, std::move(options));
  }
  static std::vector<Expected> inOrder(std::vector<Expected> messages) {
    std::ranges::stable_sort(messages, {}, &Expected::time);
    return messages;
  }
  /// Messages whose times are up to `jitter` from their order in the file; many are equal.
  static std::vector<Expected> shuffled(int count, int jitter, std::minstd_rand& random) {
    std::vector<Expected> messages = someMessages(count, 5);
    for (Expected& expected : messages) {
      const auto off = static_cast<std::int64_t>(random() % static_cast<unsigned>(2 * jitter + 1)) - jitter;
      expected.time = std::max<std::int64_t>(0, expected.time / 10 + off);
    }
    return messages;
  }
  void flipByte(std::uint64_t place) {
    std::string bytes = readBytes(file_);
    bytes[place] = static_cast<char>(bytes[place] ^ 0x10);
    writeBytes(file_, bytes);
  }

  /// In chunks of 10 messages, which are neither compressed nor have a CRC.
  void writeUnguarded(const std::vector<Expected>& messages) {
    Writer::Options options;
    options.compression = Compression::kNone;
    options.crc = false;
    writeLog(file_, messages, options, {10, 20});
  }
  /// Where in the file the records of such a chunk begin; those of the last one are messages only.
  std::size_t recordsOfChunk(std::size_t number) {
    constexpr std::size_t kHeadBytes = 49;
    return test::open(file_)->chunks()[number].offset + kHeadBytes;
  }
  std::uint64_t lengthOf(std::size_t record) const {
    std::uint64_t length = 0;
    std::memcpy(&length, readBytes(file_).data() + record + 1, sizeof length);
    return length;
  }
  void lengthen(std::size_t record, std::uint64_t length) {
    std::string bytes = readBytes(file_);
    std::memcpy(bytes.data() + record + 1, &length, sizeof length);
    writeBytes(file_, bytes);
  }
  static std::vector<std::string> damageOf(const Reader& reader) {
    std::vector<std::string> texts;
    for (const Damage& damage : reader.damage()) texts.push_back(damage.what);
    return texts;
  }

  TemporaryFolder folder_;
  std::filesystem::path file_ = folder_ / "log.mcap";
};

TEST_F(MessageCursorTest, messagesInOrderComeAsTheyAreInTheFile) {
  const std::vector<Expected> messages = someMessages(200);
  const auto reader = written(messages, 30);
  EXPECT_EQ(readByCursor(*reader), messages);
}

TEST_F(MessageCursorTest, theOrderIsThatOfTimeAndThenOfTheFileHoweverChunksOverlap) {
  std::minstd_rand random(1);
  for (const int jitter : {0, 1, 3, 10, 40, 150}) {
    const std::vector<Expected> messages = shuffled(150, jitter, random);
    for (const std::size_t inChunk : {1U, 2U, 7U, 40U}) {
      const auto reader = written(messages, inChunk);
      EXPECT_EQ(readByCursor(*reader), inOrder(messages)) << jitter << " " << inChunk;
    }
  }
}

TEST_F(MessageCursorTest, someChannelsAloneComeAsByStepping) {
  std::minstd_rand random(2);
  const auto reader = written(shuffled(150, 10, random), 9);
  for (const std::vector<std::uint16_t>& channels :
       {std::vector<std::uint16_t>{2}, {3, 1}, {}, {7}, {2, 7}}) {
    EXPECT_EQ(readByCursor(*reader, channels), readForwards(*reader, channels));
  }
}

TEST_F(MessageCursorTest, itGoesToAnyPlace) {
  std::minstd_rand random(3);
  const std::vector<Expected> messages = inOrder(shuffled(100, 10, random));
  const auto reader = written(messages, 9);
  MessageCursor cursor(*reader, kAll);
  for (int i = 0; i < 200; ++i) {
    const auto time = static_cast<std::int64_t>(random() % 120);
    cursor.seek({at(time), 0, 0, 0});
    const auto first = std::ranges::lower_bound(messages, time, {}, &Expected::time);
    for (auto expected = first; expected != messages.end() && expected - first < 5; ++expected) {
      ASSERT_TRUE(cursor.next());
      ASSERT_EQ(readFrom(cursor.message()), *expected) << time;
    }
  }
}

TEST_F(MessageCursorTest, itGoesOnBehindThePositionOfAnyMessage) {
  std::minstd_rand random(4);
  const auto reader = written(shuffled(60, 5, random), 9);
  std::vector<MessagePosition> positions;
  std::vector<Expected> all;
  MessageCursor cursor(*reader, kAll);
  while (cursor.next()) {
    positions.push_back(cursor.position());
    all.push_back(readFrom(cursor.message()));
  }
  ASSERT_TRUE(std::ranges::is_sorted(positions));
  for (std::size_t i = 0; i < positions.size(); ++i) {
    ASSERT_EQ(readFrom(reader->read(positions[i]).value().message), all[i]);
    cursor.seek(positions[i]);
    ASSERT_EQ(cursor.next(), i + 1 < all.size());
    if (i + 1 < all.size()) {
      ASSERT_EQ(readFrom(cursor.message()), all[i + 1]);
    }
  }
}

TEST_F(MessageCursorTest, atTheEndItStaysUntilItIsSentElsewhere) {
  const auto reader = written(someMessages(3), 2);
  MessageCursor cursor(*reader, kAll);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(cursor.next());
  for (int i = 0; i < 3; ++i) EXPECT_FALSE(cursor.next());
  cursor.seek({at(30), 0, 0, 0});
  EXPECT_TRUE(cursor.next());
  EXPECT_FALSE(cursor.next());
}

TEST_F(MessageCursorTest, theReaderMayBeAskedInBetween) {
  std::minstd_rand random(5);
  Reader::Options options;
  options.cacheBytes = 600;
  const std::vector<Expected> messages = shuffled(150, 2, random);
  const auto reader = written(messages, 9, options);
  std::vector<Expected> found;
  std::vector<Reader::MessageData> kept;
  for (MessageCursor cursor(*reader, kAll); cursor.next();) {
    found.push_back(readFrom(cursor.message()));
    if (found.size() % 7 == 0) kept.push_back(cursor.data());
    const auto newest = reader->latest(2, at(static_cast<std::int64_t>(random() % 150)));
    if (newest) {
      ASSERT_TRUE(reader->read(*newest));
    }
  }
  EXPECT_EQ(found, inOrder(messages));
  for (std::size_t i = 0; i < kept.size(); ++i) EXPECT_EQ(readFrom(kept[i].message), found[7 * i + 6]);
}

// A log of which each chunk goes from its start to its end cannot be held in memory.
TEST_F(MessageCursorTest, whereTooManyChunksOverlapItGoesByStepsAndFindsTheSame) {
  std::minstd_rand random(6);
  Reader::Options options;
  options.cacheBytes = 1000;
  const std::vector<Expected> messages = shuffled(300, 300, random);
  const auto reader = written(messages, 9, options);
  EXPECT_EQ(readByCursor(*reader), inOrder(messages));
}

TEST_F(MessageCursorTest, ofADamagedChunkThePlacesOfItsMessagesAreKnown) {
  const std::vector<Expected> messages = someMessages(100);
  const std::uint64_t inside = [&] {
    const Reader::ChunkInfo chunk = written(messages, 10)->chunks()[4];
    return chunk.offset + chunk.length - 5;
  }();
  flipByte(inside);
  const auto reader = test::open(file_);
  std::vector<Expected> read;
  std::vector<std::int64_t> lost;
  for (MessageCursor cursor(*reader, kAll); cursor.next();) {
    if (cursor.readable()) {
      read.push_back(readFrom(cursor.message()));
    } else {
      lost.push_back(cursor.position().time.time_since_epoch().count());
      EXPECT_EQ(cursor.position().channelId, messages[lost.size() + 39].channelId);
    }
  }
  std::vector<Expected> expected = messages;
  expected.erase(expected.begin() + 40, expected.begin() + 50);
  EXPECT_EQ(read, expected);
  ASSERT_THAT(lost, SizeIs(10));
  EXPECT_EQ(lost.front(), messages[40].time);
  EXPECT_EQ(lost.back(), messages[49].time);
  EXPECT_THAT(reader->damage(), SizeIs(1));
}

TEST_F(MessageCursorTest, ofADamagedChunkThatOverlapsOthersNothingElseIsMissing) {
  std::minstd_rand random(7);
  const std::vector<Expected> messages = shuffled(100, 15, random);
  const std::uint64_t inside = [&] {
    const Reader::ChunkInfo chunk = written(messages, 10)->chunks()[4];
    return chunk.offset + chunk.length - 5;
  }();
  flipByte(inside);
  const auto reader = test::open(file_);
  std::vector<Expected> expected = messages;
  expected.erase(expected.begin() + 40, expected.begin() + 50);
  EXPECT_EQ(readByCursor(*reader), inOrder(expected));
}

// Nothing but its structure guards the records of a chunk without a CRC.
TEST_F(MessageCursorTest, whereTheRecordsOfAChunkBreakOffMessagesAreFoundByTheirIndexes) {
  const std::vector<Expected> messages = someMessages(30);
  writeUnguarded(messages);
  const std::size_t schema = recordsOfChunk(0);
  lengthen(schema + kRecordHeadBytes + lengthOf(schema), std::uint64_t{1} << 40U);  // of a channel's record
  const std::vector<std::string> expected{"the records of a chunk do not fill it"};

  const auto reader = test::open(file_);
  EXPECT_EQ(readForwards(*reader), messages);
  EXPECT_EQ(readByCursor(*reader), messages);
  EXPECT_EQ(damageOf(*reader), expected);
  EXPECT_EQ(readByCursor(*reader, {2}), readForwards(*reader, {2}));
  EXPECT_EQ(reader->verify()->messages, messages.size());
  EXPECT_EQ(damageOf(*reader), expected);

  const auto another = test::open(file_);
  EXPECT_EQ(test::readAll(*another), messages);
  EXPECT_EQ(damageOf(*another), expected);
  const auto report = repair(file_, folder_ / "repaired.mcap");
  ASSERT_TRUE(report) << report.error().describe();
  EXPECT_EQ(report->messages, messages.size());
  EXPECT_EQ(report->damage.size(), 1U);
}

TEST_F(MessageCursorTest, whereTheRecordsOfAChunkBreakOffAtAMessageThoseBeforeAreFound) {
  std::vector<Expected> messages = someMessages(30);
  writeUnguarded(messages);
  const std::size_t first = recordsOfChunk(2);
  lengthen(first + kRecordHeadBytes + lengthOf(first), std::uint64_t{1} << 40U);
  messages.resize(21);

  const auto reader = test::open(file_);
  EXPECT_EQ(readByCursor(*reader), messages);
  EXPECT_EQ(readForwards(*reader), messages);
  EXPECT_THAT(damageOf(*reader), testing::Contains("the records of a chunk do not fill it"));
  const auto another = test::open(file_);
  EXPECT_EQ(readForwards(*another), messages);
  EXPECT_EQ(readByCursor(*another), messages);
  EXPECT_THAT(damageOf(*another), testing::Contains("the records of a chunk do not fill it"));
}

TEST_F(MessageCursorTest, itReportsMessageIndexesThatListOthersThanTheRecordsOfTheirChunk) {
  const std::vector<Expected> messages = someMessages(30);
  writeUnguarded(messages);
  const std::size_t first = recordsOfChunk(2);
  const std::size_t second = first + kRecordHeadBytes + lengthOf(first);
  lengthen(first, lengthOf(first) + kRecordHeadBytes + lengthOf(second));  // swallows the second message

  const auto reader = test::open(file_);
  const std::vector<Expected> read = readByCursor(*reader);
  EXPECT_THAT(read, SizeIs(messages.size() - 1));
  EXPECT_EQ(readForwards(*reader), read);
  EXPECT_EQ(damageOf(*reader),
            std::vector<std::string>{
                "the message indexes of a chunk are wrong; its messages are found by reading it"});
}

TEST_F(MessageCursorTest, aMessageIndexThatIsLongerThanItsEntriesLosesNothing) {
  const std::vector<Expected> messages = someMessages(30);
  const Reader::ChunkInfo chunk = written(messages, 10)->chunks()[2];
  std::string bytes = readBytes(file_);
  bytes[chunk.offset + chunk.length + kRecordHeadBytes + 2] -= 16;
  writeBytes(file_, bytes);
  const auto reader = test::open(file_);
  EXPECT_EQ(readForwards(*reader), messages);
  EXPECT_EQ(readByCursor(*reader), messages);
  EXPECT_THAT(reader->damage(), SizeIs(1));
}

// Nothing guards the times in a chunk's head; what lies before the place reached comes too late.
TEST_F(MessageCursorTest, aChunkWhoseHeadLiesAboutItsEndLosesNothing) {
  const std::vector<Expected> messages = someMessages(100);
  const Reader::ChunkInfo chunk = written(messages, 10)->chunks()[4];
  std::string bytes = readBytes(file_).substr(0, test::open(file_)->chunks().back().offset);
  const std::size_t end = chunk.offset + 9 + 8;
  for (std::size_t i = 0; i < 8; ++i) bytes[end + i] = bytes[end - 8 + i];  // as its start
  writeBytes(file_, bytes);
  const auto reader = test::open(file_);
  std::vector<Expected> expected = messages;
  expected.resize(90);
  EXPECT_EQ(readByCursor(*reader), expected);
}

}  // namespace
