// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <algorithm>

#include "logplayer/mcap/RecordBytes.h"
#include "tests/logplayer/mcap/TemporaryLog.h"

using namespace logplayer::mcap;
using namespace logplayer::mcap::test;
using testing::ElementsAre;
using testing::IsEmpty;

namespace {

Writer::Options compressedBy(Compression compression, std::size_t chunkBytes = 1000) {
  Writer::Options options;
  options.compression = compression;
  options.chunkBytes = chunkBytes;
  return options;
}

class WriteThenRead : public testing::TestWithParam<Compression> {
 protected:
  TemporaryFolder folder_;
};

TEST_P(WriteThenRead, whatWasWrittenIsReadForwardsAndBackwards) {
  const std::vector<Expected> messages = someMessages(200);
  writeLog(folder_ / "log.mcap", messages, compressedBy(GetParam()));
  const auto reader = test::open(folder_ / "log.mcap");
  ASSERT_NE(reader, nullptr);
  EXPECT_TRUE(reader->complete());
  EXPECT_GT(reader->chunks().size(), 5U);
  EXPECT_EQ(reader->chunks().front().compression, GetParam());
  EXPECT_EQ(readAll(*reader), messages);
  EXPECT_EQ(readForwards(*reader), messages);
  std::vector<Expected> backwards = readBackwards(*reader);
  std::ranges::reverse(backwards);
  EXPECT_EQ(backwards, messages);
  EXPECT_THAT(reader->damage(), IsEmpty());
}

TEST_P(WriteThenRead, aFileWithoutItsEndIsScanned) {
  const std::vector<Expected> messages = someMessages(200);
  writeLog(folder_ / "log.mcap", messages, compressedBy(GetParam()));
  const auto whole = test::open(folder_ / "log.mcap");
  std::string bytes = readBytes(folder_ / "log.mcap");
  bytes.resize(whole->chunks().back().offset);
  writeBytes(folder_ / "cut.mcap", bytes);

  const auto reader = test::open(folder_ / "cut.mcap");
  ASSERT_NE(reader, nullptr);
  EXPECT_FALSE(reader->complete());
  EXPECT_EQ(reader->channels(), whole->channels());
  EXPECT_EQ(reader->schemas(), whole->schemas());
  const std::vector<Expected> left = readForwards(*reader);
  EXPECT_EQ(reader->chunks().size() + 1, whole->chunks().size());
  EXPECT_EQ(reader->statistics().messageCount, left.size());
  ASSERT_LT(left.size(), messages.size());
  EXPECT_EQ(left, std::vector<Expected>(messages.begin(),
                                        messages.begin() + static_cast<std::ptrdiff_t>(left.size())));
}

INSTANTIATE_TEST_SUITE_P(Compressions, WriteThenRead,
                         testing::Values(Compression::kNone, Compression::kLz4, Compression::kZstd));

class WriterTest : public testing::Test {
 protected:
  std::unique_ptr<Writer> create(Writer::Options options = {}) {
    auto writer = Writer::create(folder_ / "log.mcap", std::move(options));
    EXPECT_TRUE(writer);
    addChannels(**writer, 3);
    return std::move(*writer);
  }
  TemporaryFolder folder_;
};

TEST_F(WriterTest, theStatisticsCountWhatWasWritten) {
  writeLog(folder_ / "log.mcap", someMessages(10));
  const auto reader = test::open(folder_ / "log.mcap");
  const Statistics& statistics = reader->statistics();
  EXPECT_EQ(statistics.messageCount, 10U);
  EXPECT_EQ(statistics.channelCount, 3U);
  EXPECT_EQ(statistics.schemaCount, 1U);
  EXPECT_EQ(statistics.chunkCount, 1U);
  EXPECT_EQ(statistics.messageStart, at(10));
  EXPECT_EQ(statistics.messageEnd, at(100));
  EXPECT_THAT(statistics.channelMessageCounts,
              ElementsAre(testing::Pair(1, 4), testing::Pair(2, 3), testing::Pair(3, 3)));
}

TEST_F(WriterTest, aFileThatExistsIsNotTouched) {
  writeBytes(folder_ / "log.mcap", "mine");
  const auto writer = Writer::create(folder_ / "log.mcap", {});
  ASSERT_FALSE(writer);
  EXPECT_EQ(writer.error().id, "mcap.exists");
  EXPECT_EQ(readBytes(folder_ / "log.mcap"), "mine");
}

TEST_F(WriterTest, aLargeMessageGetsAChunkOfItsOwn) {
  const auto writer = create();
  write(*writer, {1, 0, 10, "small"});
  write(*writer, {2, 0, 20, std::string(200U << 10U, 'L')});
  write(*writer, {1, 1, 30, "small too"});
  ASSERT_TRUE(writer->close());
  const auto reader = test::open(folder_ / "log.mcap");
  ASSERT_EQ(reader->chunks().size(), 2U);
  EXPECT_EQ(reader->chunks()[0].messages, 1U);
  EXPECT_EQ(reader->chunks()[1].messages, 2U);
  EXPECT_THAT(readForwards(*reader),
              ElementsAre(Expected{1, 0, 10, "small"}, testing::Field(&Expected::time, 20),
                          Expected{1, 1, 30, "small too"}));
}

TEST_F(WriterTest, aChunkIsWrittenWhenItIsOldEnough) {
  robotlink::ManualClock clock;
  Writer::Options options;
  options.clock = &clock;
  const auto writer = create(options);
  const std::uint64_t before = writer->bytesWritten();
  write(*writer, {1, 0, 10, "a"});
  clock.advance(std::chrono::milliseconds(999));
  ASSERT_TRUE(writer->tick());
  EXPECT_EQ(writer->bytesWritten(), before);
  clock.advance(std::chrono::milliseconds(1));
  ASSERT_TRUE(writer->tick());
  EXPECT_GT(writer->bytesWritten(), before);
}

TEST_F(WriterTest, aGroupStaysTogether) {
  robotlink::ManualClock clock;
  Writer::Options options;
  options.clock = &clock;
  options.chunkBytes = 100;
  const auto writer = create(options);
  const std::uint64_t before = writer->bytesWritten();
  writer->beginGroup();
  for (int i = 0; i < 20; ++i) {
    clock.advance(std::chrono::seconds(1));
    write(*writer, {1, 0, i, "part of a group"});
    ASSERT_TRUE(writer->flush());
  }
  EXPECT_EQ(writer->bytesWritten(), before);
  ASSERT_TRUE(writer->endGroup());
  EXPECT_GT(writer->bytesWritten(), before);
  ASSERT_TRUE(writer->close());
  EXPECT_EQ(test::open(folder_ / "log.mcap")->chunks().size(), 1U);
}

TEST_F(WriterTest, theSameSchemaAndChannelHaveTheSameId) {
  const auto writer = create();
  EXPECT_EQ(writer->addSchema("s", "protobuf", "described by this").value(), 1);
  EXPECT_EQ(writer->addSchema("s", "protobuf", "described otherwise").value(), 2);
  EXPECT_EQ(writer->addChannel("c2", 1, "protobuf", {{"process", "p"}}).value(), 2);
  EXPECT_EQ(writer->addChannel("c2", 2, "protobuf", {{"process", "p"}}).value(), 4);
  EXPECT_FALSE(writer->addChannel("c", 9, "protobuf", {}));
  EXPECT_FALSE(writer->write({77, 0, at(0), at(0), {}}));
}

TEST_F(WriterTest, moreThan65535ChannelsAreRefused) {
  const auto writer = create();
  for (int i = 4; i <= 65535; ++i) ASSERT_EQ(writer->addChannel(std::to_string(i), 0, "", {}).value(), i);
  const auto refused = writer->addChannel("one more", 0, "", {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().id, "mcap.too-many");
}

TEST_F(WriterTest, attachmentsAndMetadataAreReadBack) {
  const Attachment attachment{at(1), at(2), "notes.txt", "text/plain", std::string("a\0b", 3)};
  const Metadata metadata{"robotcontrol.recording", {{"dropped_messages", "0"}, {"software", "1"}}};
  const auto writer = create();
  write(*writer, {1, 0, 10, "a"});
  ASSERT_TRUE(writer->attach(attachment));
  ASSERT_TRUE(writer->addMetadata(metadata));
  ASSERT_TRUE(writer->close());
  const auto reader = test::open(folder_ / "log.mcap");
  EXPECT_THAT(reader->attachmentNames(), ElementsAre("notes.txt"));
  EXPECT_EQ(reader->attachment("notes.txt").value(), attachment);
  EXPECT_FALSE(reader->attachment("others"));
  EXPECT_THAT(reader->metadata(), ElementsAre(metadata));
}

TEST_F(WriterTest, channelsWithoutMessagesAreInTheFile) {
  ASSERT_TRUE(create()->close());
  const std::string bytes = readBytes(folder_ / "log.mcap");
  const auto reader = test::open(folder_ / "log.mcap");
  EXPECT_TRUE(reader->complete());
  EXPECT_EQ(reader->channels().size(), 3U);
  EXPECT_THAT(readForwards(*reader), IsEmpty());
  writeBytes(folder_ / "cut.mcap", bytes.substr(0, bytes.size() - 8));
  EXPECT_EQ(test::open(folder_ / "cut.mcap")->channels(), reader->channels());
}

TEST_F(WriterTest, theDestructorCloses) {
  { write(*create(), {1, 0, 10, "a"}); }
  EXPECT_TRUE(test::open(folder_ / "log.mcap")->complete());
}

}  // namespace
