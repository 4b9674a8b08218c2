// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/mcap/read/SectionCache.h"

#include <gmock/gmock.h>

#include "tests/logplayer/mcap/BuiltFile.h"

using namespace logplayer::mcap;
using namespace logplayer::mcap::test;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

namespace {

constexpr char kWrongIndexes[] =
    "the message indexes of a chunk are wrong; its messages are found by reading it";

std::vector<Expected> twoMessages(std::int64_t first = 10) {
  return {{1, 0, first, "some"}, {1, 1, first + 10, "more"}};
}

/// The times of the messages of channel 1 in a section.
std::vector<std::int64_t> timesIn(SectionCache& cache, std::size_t section) {
  std::vector<std::int64_t> times;
  const auto list = cache.messages(section);
  for (const MessageList::Entry& entry : list->of(1)) times.push_back(entry.time.time_since_epoch().count());
  return times;
}

/// Chunks of two messages of channel 1 each.
BuiltFile chunks(int count) {
  BuiltFile file;
  file.addChannels(1);
  for (int i = 0; i < count; ++i) file.addIndexed(twoMessages(100 * i));
  return file;
}

TEST(SectionCache, recordsAreReadOnceWhileTheyFit) {
  const BuiltFile file = chunks(3);
  ScannedFile scanned(file);
  const auto first = scanned.cache.records(0);
  ASSERT_TRUE(first);
  EXPECT_EQ(**first, recordsOf(twoMessages(0)));
  EXPECT_EQ(*scanned.cache.records(0), *first);
  ScannedFile small(file, {.cacheBytes = 1, .progress = {}});
  const Buffer* newest = small.cache.records(0)->get();
  EXPECT_EQ(small.cache.records(0)->get(), newest);
  EXPECT_EQ(small.cache.records(1)->get(), newest) << "it takes the place of the other";
}

TEST(SectionCache, theBufferOfASectionThatWasLeftIsReused) {
  const BuiltFile file = chunks(3);
  ScannedFile scanned(file);
  const auto* memory = (*scanned.cache.records(0))->data();
  scanned.cache.leave(0);
  EXPECT_EQ((*scanned.cache.records(1))->data(), memory);
  const auto held = *scanned.cache.records(1);
  scanned.cache.leave(1);
  EXPECT_NE((*scanned.cache.records(2))->data(), held->data()) << "somebody still holds it";
  EXPECT_EQ(*held, recordsOf(twoMessages(100)));
}

TEST(SectionCache, aSectionThatIsAskedForAgainAfterItWasLeftIsKept) {
  const BuiltFile file = chunks(3);
  ScannedFile scanned(file);
  ASSERT_TRUE(scanned.cache.records(0));
  scanned.cache.leave(0);
  ASSERT_TRUE(scanned.cache.records(1));
  ASSERT_TRUE(scanned.cache.records(0));  // a walk goes back and forth
  scanned.cache.leave(0);
  const Buffer* kept = scanned.cache.records(0)->get();
  EXPECT_NE(scanned.cache.records(2)->get(), kept);
  EXPECT_EQ(*kept, recordsOf(twoMessages(0)));
}

TEST(SectionCache, aDamagedSectionIsReportedOnceAndHasNoMessages) {
  BuiltFile file = chunks(1);
  file.addChunk({0xFF, 0xFF}, 5, 6);
  ScannedFile scanned(file);
  scanned.index.damage.clear();
  Section broken = scanned.index.sections[0];
  ++broken.info.compressedBytes;
  scanned.index.sections.push_back(broken);
  scanned.cache.reset();
  const std::size_t last = scanned.index.sections.size() - 1;
  for (int i = 0; i < 3; ++i) {
    const auto records = scanned.cache.records(last);
    ASSERT_FALSE(records);
    EXPECT_EQ(records.error(), "a chunk's head is damaged");
  }
  Buffer buffer;
  EXPECT_FALSE(scanned.cache.readInto(last, buffer));
  EXPECT_THAT(scanned.damage(), ElementsAre("a chunk's head is damaged"));
  EXPECT_EQ(scanned.index.damage[0].chunks, 1U);
  scanned.index.sections[last].indexed = false;
  EXPECT_EQ(scanned.cache.messages(last)->messages(), 0U);
}

TEST(SectionCache, indexesThatAreNotBelievedAreReplacedByTheRecords) {
  const BuiltFile file = chunks(2);
  ScannedFile scanned(file);
  EXPECT_THAT(timesIn(scanned.cache, 1), ElementsAre(100, 110));
  EXPECT_EQ(scanned.cache.surprises(), 0U);
  scanned.cache.distrustIndexes(1);
  scanned.cache.distrustIndexes(1);
  EXPECT_EQ(scanned.cache.surprises(), 1U);
  EXPECT_FALSE(scanned.index.sections[1].indexed);
  EXPECT_THAT(scanned.damage(), ElementsAre(kWrongIndexes));
  EXPECT_THAT(timesIn(scanned.cache, 1), ElementsAre(100, 110));
  EXPECT_TRUE(scanned.index.sections[0].indexed);
}

TEST(SectionCache, indexesThatListOthersThanTheRecordsAreNotBelieved) {
  const BuiltFile file = chunks(1);
  ScannedFile scanned(file);
  scanned.cache.compareIndexes(0, MessageList::fromRecords(recordsOf(twoMessages(0))));
  EXPECT_THAT(scanned.damage(), IsEmpty());
  scanned.cache.compareIndexes(0, MessageList::fromRecords(recordsOf(twoMessages(1))));
  EXPECT_THAT(scanned.damage(), ElementsAre(kWrongIndexes));
}

TEST(SectionCache, damagedIndexesAreNoticedWhenMessagesAreListed) {
  BuiltFile file = chunks(1);
  file.bytes[file.size() - 16] = 99;  // the time of the last entry
  ScannedFile scanned(file);
  EXPECT_THAT(timesIn(scanned.cache, 0), ElementsAre(0, 10));
  EXPECT_THAT(scanned.damage(), ElementsAre(kWrongIndexes));
}

TEST(SectionCache, whereRecordsBreakOffMessagesAreThoseOfTheIndexesOrThoseBefore) {
  BuiltFile file;
  file.addChannels(1);
  const std::uint64_t start = file.addIndexed(twoMessages());
  constexpr std::size_t kHead = 49;
  storeNumber(file.bytes.data() + start + kHead + 1, std::uint64_t{1} << 40U);  // the first message's length
  ScannedFile scanned(file);
  const auto records = scanned.cache.records(0);
  ASSERT_TRUE(records);
  EXPECT_THAT(scanned.cache.messagesOfBroken(0, **records), IsEmpty()) << "the index names one that is gone";
  EXPECT_THAT(scanned.damage(), ElementsAre("the records of a chunk do not fill it", kWrongIndexes));

  BuiltFile second = chunks(0);
  second.addIndexed(twoMessages());
  Buffer torn = recordsOf(twoMessages());
  torn.push_back(0xFF);
  ScannedFile whole(second);
  EXPECT_THAT(whole.cache.messagesOfBroken(0, torn), SizeIs(2));
  EXPECT_TRUE(whole.index.sections[0].indexed);
}

TEST(SectionCache, timesBeyondThoseOfTheHeadAreASurprise) {
  const BuiltFile file = chunks(1);
  ScannedFile scanned(file);
  scanned.cache.correctTimes(0, at(2), at(8));
  EXPECT_EQ(scanned.cache.surprises(), 0U);
  scanned.cache.correctTimes(0, at(5), at(30));
  EXPECT_EQ(scanned.cache.surprises(), 1U);
  EXPECT_EQ(scanned.index.sections[0].info.start, at(0));
  EXPECT_EQ(scanned.index.sections[0].info.end, at(30));
}

TEST(SectionCache, onlyASummaryCanBeAMisfit) {
  const BuiltFile file = chunks(2);
  ScannedFile scanned(file);
  ++scanned.index.sections[1].info.offset;
  scanned.cache.doubtAll();
  EXPECT_FALSE(scanned.cache.misfit()) << "it comes from the file itself";
  scanned.index.bySummary = true;
  scanned.cache.doubtAll();
  EXPECT_TRUE(scanned.cache.misfit());
  scanned.cache.reset();
  EXPECT_FALSE(scanned.cache.misfit());
  EXPECT_FALSE(scanned.cache.records(1));
  EXPECT_TRUE(scanned.cache.misfit()) << "damage raises the doubt";
}

}  // namespace
