// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/mcap/read/Scan.h"

#include <gmock/gmock.h>

#include "tests/logplayer/mcap/BuiltFile.h"

using namespace logplayer::mcap;
using namespace logplayer::mcap::test;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

namespace {

/// What is to be compared of a section.
auto partsOf(const Section& section) {
  const ChunkInfo& info = section.info;
  return std::tuple(info.offset, info.length, info.start, info.end, info.messages, info.compressedBytes,
                    info.uncompressedBytes, section.loose, section.indexed, section.indexOffset,
                    section.indexLength, section.channels);
}

FileIndex scanned(const BuiltFile& file) {
  return indexByScan(file.source(), {});
}

TEST(Scan, findsWhatTheSummaryStates) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder / "log.mcap";
  Writer::Options options;
  options.compression = Compression::kLz4;
  options.profile = "p";
  auto writer = Writer::create(file, options);
  addChannels(**writer, 3);
  for (const Expected& message : someMessages(30)) {
    write(**writer, message);
    if (message.sequence % 10 == 9) {
      ASSERT_TRUE((*writer)->flush());
    }
  }
  ASSERT_TRUE((*writer)->attach({at(1), at(2), "notes", "text/plain", "some"}));
  ASSERT_TRUE((*writer)->addMetadata({"m", {{"a", "b"}}}));
  ASSERT_TRUE((*writer)->close());

  const auto source = Source::open(file);
  const auto stated = indexBySummary(*source, 1U << 20U);
  ASSERT_TRUE(stated);
  const FileIndex found = indexByScan(*source, {});
  EXPECT_EQ(found.header, stated->header);
  EXPECT_EQ(found.schemas, stated->schemas);
  EXPECT_EQ(found.channels, stated->channels);
  EXPECT_EQ(found.statistics, stated->statistics);
  EXPECT_EQ(found.attachments, stated->attachments);
  EXPECT_EQ(found.metadata, stated->metadata);
  EXPECT_EQ(found.dataEnd, stated->dataEnd);
  EXPECT_EQ(found.dataCrc, stated->dataCrc);
  EXPECT_TRUE(found.complete);
  EXPECT_FALSE(found.bySummary);
  ASSERT_THAT(found.sections, SizeIs(3));
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(partsOf(found.sections[i]), partsOf(stated->sections[i]));
}

TEST(Scan, aChunkWithoutIndexesIsReadForItsTimesAndMessages) {
  BuiltFile file;
  file.addChannels(1);
  file.addChunk(recordsOf({{1, 0, 30, "a"}, {1, 1, 20, "b"}}), 5, 6);
  const FileIndex index = scanned(file);
  ASSERT_THAT(index.sections, SizeIs(1));
  const Section& section = index.sections[0];
  EXPECT_FALSE(section.indexed);
  EXPECT_EQ(section.info.messages, 2U);
  EXPECT_EQ(section.info.start, at(20)) << "the head of the chunk lies";
  EXPECT_EQ(section.info.end, at(30));
  EXPECT_EQ(index.statistics.channelMessageCounts.at(1), 2U);
  EXPECT_EQ(index.statistics.messageStart, at(20));
}

TEST(Scan, anIndexedChunkIsReadOnlyForChannelsThatAreNotKnown) {
  BuiltFile file;
  Buffer records;
  encode(records, Channel{1, 0, "inside", "", {}});
  const std::uint64_t offset = records.size();
  const Buffer message = recordsOf({{1, 0, 5, "x"}});
  records.insert(records.end(), message.begin(), message.end());
  file.addChunk(records, 5, 5);
  file.add(MessageIndex{1, {{5, offset}}});
  file.addChunk({0xFF, 0xFF}, 7, 7);  // cannot be read
  file.add(MessageIndex{1, {{7, 0}}});
  file.end();
  const FileIndex index = scanned(file);
  EXPECT_EQ(index.channels.at(1).topic, "inside");
  EXPECT_EQ(index.statistics.messageCount, 2U);
  EXPECT_TRUE(index.sections.at(0).indexed);
}

TEST(Scan, messagesOutsideOfChunksAreSectionsOfAboutOneMebibyte) {
  BuiltFile file;
  file.addChannels(1);
  const std::uint64_t start = file.size();
  for (const std::int64_t time : {20, 10, 30})
    file.add(Message{1, 0, at(time), at(time), bytesOf("some data")});
  const std::string large(700U << 10U, 'x');
  file.add(Message{1, 0, at(40), at(40), bytesOf(large)});
  const std::uint64_t second = file.add(Message{1, 0, at(50), at(50), bytesOf(large)});
  file.end();
  const FileIndex index = scanned(file);
  ASSERT_THAT(index.sections, SizeIs(2));
  EXPECT_TRUE(index.sections[0].loose);
  EXPECT_EQ(index.sections[0].info.offset, start);
  EXPECT_EQ(index.sections[0].info.length, second - start);
  EXPECT_EQ(index.sections[0].info.start, at(10));
  EXPECT_EQ(index.sections[0].info.end, at(40));
  EXPECT_EQ(index.sections[0].info.messages, 4U);
  EXPECT_EQ(index.sections[1].info.messages, 1U);
  EXPECT_EQ(index.statistics.chunkCount, 0U);
  EXPECT_TRUE(index.complete);
}

TEST(Scan, afterGarbageItContinuesAtTheNextChunk) {
  BuiltFile file;
  file.addChannels(1);
  file.addIndexed({{1, 0, 10, "a"}});
  const std::uint64_t garbage = file.addBytes(100, 0xFF);
  const std::uint64_t second = file.addIndexed({{1, 1, 20, "b"}});
  file.end();
  const FileIndex index = scanned(file);
  ASSERT_THAT(index.sections, SizeIs(2));
  EXPECT_EQ(index.sections[1].info.offset, second);
  ASSERT_THAT(index.damage, SizeIs(1));
  EXPECT_EQ(index.damage[0].offset, garbage);
  EXPECT_EQ(index.damage[0].bytes, 100U);
  EXPECT_THAT(index.damage[0].what, HasSubstr("reading continues"));
  EXPECT_FALSE(index.complete);
}

TEST(Scan, zerosAtTheEndWereNeverWrittenAndAreNotLost) {
  BuiltFile file;
  file.addChannels(1);
  file.addIndexed({{1, 0, 10, "a"}});
  const std::uint64_t zeros = file.addBytes(5000, 0);
  const FileIndex index = scanned(file);
  ASSERT_THAT(index.damage, SizeIs(1));
  EXPECT_EQ(index.damage[0].offset, zeros);
  EXPECT_EQ(index.damage[0].bytes, 0U);
  EXPECT_THAT(index.damage[0].what, HasSubstr("5000 zero bytes"));
  EXPECT_THAT(index.sections, SizeIs(1));
}

TEST(Scan, aFileThatEndsWithinAChunkLosesThatChunk) {
  BuiltFile file;
  file.addChannels(1);
  file.addIndexed({{1, 0, 10, "a"}});
  const std::uint64_t second = file.addIndexed({{1, 1, 20, "b"}});
  file.bytes.resize(second + 60);
  const FileIndex index = scanned(file);
  EXPECT_THAT(index.sections, SizeIs(1));
  ASSERT_THAT(index.damage, SizeIs(1));
  EXPECT_EQ(index.damage[0].offset, second);
  EXPECT_EQ(index.damage[0].bytes, 60U);
  EXPECT_EQ(index.damage[0].chunks, 1U);
  EXPECT_THAT(index.damage[0].what, HasSubstr("ends within a record"));
}

TEST(Scan, aRecordThatContradictsItselfIsSkippedAlone) {
  BuiltFile file;
  file.addChannels(1);
  const std::uint64_t attachment = file.add(Attachment{at(1), at(2), "n", "t", "data"});
  constexpr std::size_t kToSize = kRecordHeadBytes + 8 + 8 + 4 + 1 + 4 + 1;
  storeNumber(file.bytes.data() + attachment + kToSize, std::uint64_t{1000});
  file.addIndexed({{1, 0, 10, "a"}});
  file.end();
  const FileIndex index = scanned(file);
  EXPECT_THAT(index.attachments, IsEmpty());
  EXPECT_THAT(index.sections, SizeIs(1));
  ASSERT_THAT(index.damage, SizeIs(1));
  EXPECT_EQ(index.damage[0].offset, attachment);
  EXPECT_EQ(index.damage[0].what, "a record contradicts itself");
}

TEST(Scan, messageIndexesWithoutTheirChunkAreReportedOnce) {
  BuiltFile file;
  file.addChannels(2);
  file.add(MessageIndex{1, {{5, 0}}});
  file.add(MessageIndex{2, {{5, 0}}});
  file.end();
  const FileIndex index = scanned(file);
  ASSERT_THAT(index.damage, SizeIs(1));
  EXPECT_EQ(index.damage[0].what, "message indexes lack their chunk");
  EXPECT_EQ(index.statistics.messageCount, 0U);
}

TEST(Scan, messagesOfAChannelThatNothingDescribesAreReported) {
  BuiltFile file;
  file.addChunk({{7, 0, 10, "a"}, {7, 1, 11, "b"}});
  file.end();
  const FileIndex index = scanned(file);
  ASSERT_THAT(index.damage, SizeIs(1));
  EXPECT_THAT(index.damage[0].what, HasSubstr("2 messages of channel 7 cannot be decoded"));
}

TEST(Scan, chunksBehindTheEndOfAFileAreFoundToo) {
  BuiltFile file;
  file.addChannels(1);
  file.addIndexed({{1, 0, 10, "a"}});
  file.end();
  const Buffer once = file.bytes;
  file.bytes.insert(file.bytes.end(), once.begin(), once.end());
  const FileIndex index = scanned(file);
  EXPECT_THAT(index.sections, SizeIs(2));
  EXPECT_EQ(index.statistics.messageCount, 2U);
}

TEST(Scan, aRefusedReportOfProgressCancelsIt) {
  BuiltFile file;
  file.addChannels(1);
  for (int i = 0; i < 3; ++i) file.addChunk({{1, 0, 10, std::string(5U << 20U, 'x')}});
  std::vector<double> shares;
  const FileIndex index = indexByScan(file.source(), {.progress = [&](double share) {
                                        shares.push_back(share);
                                        return shares.size() < 2;
                                      }});
  EXPECT_TRUE(index.givenUp);
  EXPECT_FALSE(index.complete);
  EXPECT_THAT(shares, ElementsAre(testing::DoubleNear(1 / 3., 0.01), testing::DoubleNear(2 / 3., 0.01)));
}

}  // namespace
