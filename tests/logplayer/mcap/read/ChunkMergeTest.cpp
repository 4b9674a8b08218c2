// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/mcap/read/ChunkMerge.h"

#include <gmock/gmock.h>

#include "tests/logplayer/mcap/BuiltFile.h"

using namespace logplayer::mcap;
using namespace logplayer::mcap::test;
using testing::ElementsAre;
using testing::IsEmpty;

namespace {

constexpr std::size_t kAnySize = 1U << 20U;
const MessagePosition kStart{Instant::min(), 0, 0, 0};

/// The times of each run from a position on, in the order in which they come.
std::vector<std::vector<std::int64_t>> runs(ChunkMerge& merge, MessagePosition behind = kStart) {
  std::vector<std::vector<std::int64_t>> all;
  for (auto run = merge.next(behind); run.records != nullptr; run = merge.next(behind)) {
    std::vector<std::int64_t>& times = all.emplace_back();
    for (const MessageRecord& message : run.messages)
      times.push_back(message.time.time_since_epoch().count());
    const MessageRecord& last = run.messages.back();
    behind = {last.time, run.sectionOffset, last.offset, 0};
  }
  return all;
}

std::vector<Expected> timed(std::initializer_list<std::int64_t> times) {
  std::vector<Expected> messages;
  for (const std::int64_t time : times) messages.push_back({1, 0, time, "data"});
  return messages;
}

TEST(ChunkMerge, chunksThatDoNotOverlapAreRunsOfTheirOwn) {
  BuiltFile file;
  file.addChannels(1);
  file.addIndexed(timed({50, 60}));
  file.addIndexed(timed({10, 20, 30}));
  ScannedFile scanned(file);
  ChunkMerge merge(scanned.index, scanned.cache, {1}, kAnySize);
  EXPECT_THAT(runs(merge), ElementsAre(ElementsAre(10, 20, 30), ElementsAre(50, 60)));
}

TEST(ChunkMerge, aRunEndsWhereAnotherChunkHasTheNextMessage) {
  BuiltFile file;
  file.addChannels(1);
  file.addIndexed(timed({10, 20, 30, 60}));
  file.addIndexed(timed({20, 25, 70}));
  ScannedFile scanned(file);
  ChunkMerge merge(scanned.index, scanned.cache, {1}, kAnySize);
  EXPECT_THAT(runs(merge), ElementsAre(ElementsAre(10), ElementsAre(20), ElementsAre(20, 25),
                                       ElementsAre(30, 60), ElementsAre(70)))
      << "at 20 that of the first chunk comes first";
}

TEST(ChunkMerge, messagesThatAreNotInOrderAreSorted) {
  BuiltFile file;
  file.addChannels(1);
  file.addIndexed(timed({30, 10, 20}));
  ScannedFile scanned(file);
  ChunkMerge merge(scanned.index, scanned.cache, {1}, kAnySize);
  EXPECT_THAT(runs(merge), ElementsAre(ElementsAre(10, 20, 30)));
}

TEST(ChunkMerge, onlyMessagesOfTheChannelsCome) {
  BuiltFile file;
  file.addChannels(2);
  file.addIndexed({{1, 0, 10, ""}, {2, 0, 20, ""}, {1, 0, 30, ""}});
  file.addIndexed({{1, 0, 40, ""}});
  ScannedFile scanned(file);
  ChunkMerge merge(scanned.index, scanned.cache, {2}, kAnySize);
  EXPECT_THAT(runs(merge), ElementsAre(ElementsAre(20)));
  ChunkMerge none(scanned.index, scanned.cache, {}, kAnySize);
  EXPECT_THAT(runs(none), IsEmpty());
}

TEST(ChunkMerge, afterASeekItContinuesBehindAnyPosition) {
  BuiltFile file;
  file.addChannels(1);
  const std::uint64_t first = file.addIndexed(timed({10, 20, 30}));
  file.addIndexed(timed({25, 40}));
  ScannedFile scanned(file);
  ChunkMerge merge(scanned.index, scanned.cache, {1}, kAnySize);
  EXPECT_THAT(runs(merge, {at(22), 0, 0, 0}), ElementsAre(ElementsAre(25), ElementsAre(30), ElementsAre(40)));
  merge.seek();
  EXPECT_THAT(runs(merge, {at(30), first, UINT64_MAX, 0}), ElementsAre(ElementsAre(40)));
  merge.seek();
  EXPECT_THAT(runs(merge, {at(40), UINT64_MAX, 0, 0}), IsEmpty());
}

TEST(ChunkMerge, chunksThatOverlapMustFitButASingleOneAlwaysDoes) {
  BuiltFile file;
  file.addChannels(1);
  file.addIndexed(timed({10, 20}));
  file.addIndexed(timed({30, 40}));
  const std::size_t bytes = recordsOf(timed({10, 20})).size();
  {
    ScannedFile scanned(file);
    ChunkMerge merge(scanned.index, scanned.cache, {1}, 1);
    EXPECT_THAT(runs(merge), ElementsAre(ElementsAre(10, 20), ElementsAre(30, 40)));
    EXPECT_TRUE(merge.fits());
  }
  file.addIndexed(timed({15, 16}));
  ScannedFile scanned(file);
  ChunkMerge merge(scanned.index, scanned.cache, {1}, 2 * bytes - 1);
  EXPECT_THAT(runs(merge), IsEmpty());
  EXPECT_FALSE(merge.fits());
  ChunkMerge larger(scanned.index, scanned.cache, {1}, 2 * bytes);
  EXPECT_THAT(runs(larger),
              ElementsAre(ElementsAre(10), ElementsAre(15, 16), ElementsAre(20), ElementsAre(30, 40)));
}

TEST(ChunkMerge, ofADamagedChunkItsMessageIndexesNameTheMessages) {
  BuiltFile file;
  file.addChannels(2);
  const std::uint64_t damaged = file.addIndexed({{2, 0, 20, ""}, {1, 0, 10, ""}});
  file.bytes[damaged + kRecordHeadBytes + 8 + 8 + 8] = 1;  // a CRC that is wrong
  file.addIndexed({{1, 0, 30, ""}});
  ScannedFile scanned(file);
  ChunkMerge merge(scanned.index, scanned.cache, {1, 2}, kAnySize);
  const auto run = merge.next(kStart);
  ASSERT_NE(run.records, nullptr);
  EXPECT_EQ(*run.records, nullptr);
  ASSERT_EQ(run.messages.size(), 2U);
  EXPECT_EQ(run.messages[0].time, at(10));
  EXPECT_EQ(run.channels[0], 1);
  EXPECT_EQ(run.channels[1], 2);
  EXPECT_THAT(scanned.damage(), ElementsAre("the CRC of a chunk is wrong"));
  EXPECT_THAT(runs(merge, {at(20), damaged, 0, 2}), ElementsAre(ElementsAre(30)));
}

TEST(ChunkMerge, aChunkThatBeginsBeforeItsHeadSaysLosesNothing) {
  BuiltFile file;
  file.addChannels(1);
  file.addChunk(recordsOf(timed({10, 40})), 10, 40);
  file.addChunk(recordsOf(timed({20, 30})), 20, 30);
  ScannedFile scanned(file);
  scanned.index.sections[1].info.start = at(30);
  ChunkMerge merge(scanned.index, scanned.cache, {1}, kAnySize);
  EXPECT_THAT(runs(merge), ElementsAre(ElementsAre(10), ElementsAre(20, 30), ElementsAre(40)));
}

}  // namespace
