// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/mcap/read/FileIndex.h"

#include <gmock/gmock.h>

#include "logplayer/mcap/Summary.h"
#include "tests/logplayer/mcap/BuiltFile.h"

using namespace logplayer::mcap;
using namespace logplayer::mcap::test;
using testing::HasSubstr;
using testing::SizeIs;

namespace {

constexpr std::size_t kAnyBytes = 1U << 20U;

/// Two chunks with messages of channel 1, and the summary that fits them until a test changes it.
struct SummarizedFile : BuiltFile {
  SummarizedFile() {
    summary.channels[1] = {1, 0, "c1", "", {}};
    addChannels(1);
    for (const std::int64_t time : {10, 20}) {
      const std::uint64_t start = addChunk({{1, 0, time, "data"}});
      const std::uint64_t index = add(MessageIndex{1, {{static_cast<std::uint64_t>(time), 0}}});
      const std::uint64_t records = kMessageHeadBytes + 4;
      summary.chunks.push_back(
          {at(time), at(time), start, index - start, {{1, index}}, size() - index, "", records, records});
    }
    summary.hasStatistics = true;
    summary.statistics = {2, 0, 1, 0, 0, 2, at(10), at(20), {{1, 2}}};
  }
  /// Ends the file with the summary.
  Source ended() {
    add(DataEnd{});
    const Buffer end = encodeEnd(summary, size(), true);
    bytes.insert(bytes.end(), end.begin(), end.end());
    return source();
  }
  /// Why the summary is not used; "used" if it is.
  std::string verdict() {
    const auto index = indexBySummary(ended(), kAnyBytes);
    return index ? "used" : index.error().damage;
  }

  Summary summary;
};

TEST(FileIndex, isThatOfTheSummaryWhereItCoversTheFile) {
  SummarizedFile file;
  const auto index = indexBySummary(file.ended(), kAnyBytes);
  ASSERT_TRUE(index) << index.error().damage;
  EXPECT_TRUE(index->complete && index->bySummary);
  EXPECT_EQ(index->header.library, "test");
  EXPECT_EQ(index->statistics, file.summary.statistics);
  ASSERT_THAT(index->sections, SizeIs(2));
  const Section& section = index->sections[1];
  EXPECT_EQ(section.info.offset, file.summary.chunks[1].chunkOffset);
  EXPECT_EQ(section.info.messages, 1U);
  EXPECT_TRUE(section.mayHold(1));
  EXPECT_FALSE(section.mayHold(2));
  EXPECT_TRUE(Section().mayHold(2)) << "without message indexes it is not known";
}

TEST(FileIndex, aFileWithoutItsEndOrBeginningHasNone) {
  BuiltFile unclosed;
  unclosed.addChannels(1);
  EXPECT_THAT(indexBySummary(unclosed.source(), kAnyBytes).error().damage, HasSubstr("was not closed"));
  BuiltFile bare;
  bare.end();
  EXPECT_EQ(indexBySummary(bare.source(), kAnyBytes).error().damage, "") << "it has none, and says so";
  SummarizedFile file;
  file.bytes[sizeof kMagic + kRecordHeadBytes] = 0xFF;  // the length of a text in the header
  EXPECT_EQ(file.verdict(), "the beginning of the file is damaged");
}

TEST(FileIndex, aDamagedSummaryIsNotUsed) {
  SummarizedFile file;
  file.ended();
  const Buffer whole = file.bytes;
  const std::size_t end = whole.size() - sizeof kMagic - kFooterBytes;
  file.bytes[end - 1] ^= 1U;  // its last byte; the CRC is wrong then
  EXPECT_EQ(indexBySummary(file.source(), kAnyBytes).error().damage, "the summary is damaged");
  file.bytes = whole;
  const auto summaryStart = loadNumber<std::uint64_t>(whole.data() + end + kRecordHeadBytes);
  file.bytes[summaryStart - kDataEndBytes] = 0x70;
  EXPECT_EQ(indexBySummary(file.source(), kAnyBytes).error().damage,
            "the end of the data section is damaged");
  file.bytes = whole;
  EXPECT_EQ(indexBySummary(file.source(), 10).error().damage, "the beginning of the file is damaged")
      << "more than the limit";
}

TEST(FileIndex, aSummaryThatLeavesMessagesOutIsNotUsedButNotDamageEither) {
  const auto verdictAfter = [](const std::function<void(Summary&)>& change) {
    SummarizedFile file;
    change(file.summary);
    return file.verdict();
  };
  EXPECT_EQ(verdictAfter([](Summary&) {}), "used");
  EXPECT_EQ(verdictAfter([](Summary& summary) { ++summary.statistics.messageCount; }), "");
  EXPECT_EQ(verdictAfter([](Summary& summary) { ++summary.statistics.chunkCount; }), "");
  EXPECT_EQ(verdictAfter([](Summary& summary) { ++summary.statistics.channelCount; }), "");
  EXPECT_EQ(verdictAfter([](Summary& summary) { ++summary.statistics.schemaCount; }), "");
  EXPECT_EQ(verdictAfter([](Summary& summary) { ++summary.statistics.attachmentCount; }), "");
  EXPECT_EQ(verdictAfter([](Summary& summary) { ++summary.statistics.metadataCount; }), "");
  EXPECT_EQ(verdictAfter([](Summary& summary) { summary.chunks[0].messageIndexLength = 5; }), "");
  EXPECT_EQ(verdictAfter([](Summary& summary) { summary.chunks[0].messageIndexOffsets[0].first = 9; }), "");
}

TEST(FileIndex, chunksThatCannotLieWhereTheSummarySaysAreAMisfit) {
  const auto verdictAfter = [](const std::function<void(ChunkIndex&)>& change) {
    SummarizedFile file;
    change(file.summary.chunks[1]);
    return file.verdict();
  };
  const std::string misfit = "the summary does not fit the file";
  EXPECT_EQ(verdictAfter([](ChunkIndex& chunk) { chunk.chunkOffset -= 1; }), misfit) << "overlaps the first";
  EXPECT_EQ(verdictAfter([](ChunkIndex& chunk) { chunk.chunkOffset = UINT64_MAX; }), misfit);
  EXPECT_EQ(verdictAfter([](ChunkIndex& chunk) { chunk.chunkLength = 1; }), misfit);
  EXPECT_EQ(verdictAfter([](ChunkIndex& chunk) { chunk.chunkLength += 1000; }), misfit);
  EXPECT_EQ(verdictAfter([](ChunkIndex& chunk) { chunk.messageIndexLength += 1000; }), misfit);
  EXPECT_EQ(verdictAfter([](ChunkIndex& chunk) { chunk.end = at(1); }), misfit);
  EXPECT_EQ(verdictAfter([](ChunkIndex& chunk) { chunk.messageIndexOffsets[0].second = 0; }), misfit);
}

TEST(FileIndex, aChunkThatIsAnotherThanTheSummarySaysCausesAScan) {
  SummarizedFile file;
  const std::uint64_t place = file.summary.chunks[1].chunkOffset;
  ++file.summary.chunks[1].compressedBytes;
  const auto index = readIndex(file.ended(), {});
  ASSERT_TRUE(index);
  EXPECT_FALSE(index->bySummary);
  EXPECT_FALSE(index->complete);
  EXPECT_EQ(index->sections.back().info.offset, place);
  ASSERT_THAT(index->damage, SizeIs(1));
  EXPECT_THAT(index->damage[0].what, HasSubstr("does not fit the file"));
}

TEST(FileIndex, aScanThatFindsNoMoreThanTheSummaryIsNotBetter) {
  SummarizedFile file;
  const Source source = file.ended();
  FileIndex index = *indexBySummary(source, kAnyBytes);
  EXPECT_FALSE(betterByScan(source, index, {}));
  index.sections.pop_back();
  const auto better = betterByScan(source, index, {});
  ASSERT_TRUE(better);
  EXPECT_THAT(better->sections, SizeIs(2));
}

TEST(FileIndex, aChunkIsThereIfItsHeadOrAtLeastItsMessagesFit) {
  SummarizedFile file;
  const Source source = file.ended();
  Section section = indexBySummary(source, kAnyBytes)->sections[0];
  EXPECT_TRUE(chunkIsThere(source, section, kAnyBytes));
  section.info.start = at(0);
  EXPECT_TRUE(chunkIsThere(source, section, kAnyBytes)) << "its message lies within";
  section.info.end = at(5);
  EXPECT_FALSE(chunkIsThere(source, section, kAnyBytes));
  section = indexBySummary(source, kAnyBytes)->sections[0];
  ++section.info.uncompressedBytes;
  EXPECT_FALSE(chunkIsThere(source, section, kAnyBytes));
}

TEST(FileIndex, whatIsNoMcapIsRefused) {
  BuiltFile file;
  file.bytes.assign(1000, 'x');
  const auto index = readIndex(file.source(), {});
  ASSERT_FALSE(index);
  EXPECT_EQ(index.error().id, "mcap.none");
}

}  // namespace
