// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/mcap/read/ReadAhead.h"

#include <gmock/gmock.h>

#include "tests/Eventually.h"
#include "tests/logplayer/mcap/BuiltFile.h"

using namespace logplayer::mcap;
using namespace logplayer::mcap::test;
using robotlink::Instant;
using testing::AssertionFailure;
using testing::AssertionResult;
using testing::AssertionSuccess;
using testing::IsEmpty;
using testing::Not;

namespace {

constexpr std::size_t kBytes = 200'000;
constexpr std::size_t kLimit = 1U << 20U;

/// A file of chunks that are large enough to be read ahead, with one message each.
BuiltFile largeChunks(int count, std::size_t bytes = kBytes) {
  BuiltFile file;
  file.addChannels(1);
  for (int i = 0; i < count; ++i) {
    const std::string data(bytes, static_cast<char>('a' + i));
    file.addChunk({{1, static_cast<std::uint32_t>(i), 10 * i, data}});
  }
  return file;
}

std::string problemOf(const ReadAhead::Outcome& outcome) {
  return outcome ? "" : outcome.error();
}

/// What reads the chunks of a file ahead, up to `maxBytes`.
struct Chunks {
  explicit Chunks(const BuiltFile& file, std::size_t maxBytes = kLimit)
      : scanned(file), ahead(scanned.source, kLimit, maxBytes) {}

  void begin(std::size_t number) { ahead.begin(number, scanned.index.sections.at(number)); }
  /// Whether this chunk was read ahead, as the loader loads it.
  AssertionResult has(std::size_t number) {
    Buffer records, expected;
    const auto outcome = ahead.take(number, records);
    if (!outcome) return AssertionFailure() << "it was not read ahead";
    const auto direct = ChunkLoader(scanned.source, kLimit).load(scanned.index.sections.at(number), expected);
    if (problemOf(*outcome) != problemOf(direct)) return AssertionFailure() << "the outcome is another one";
    return !*outcome || records == expected ? AssertionSuccess() : AssertionFailure() << "the records differ";
  }

  ScannedFile scanned;
  ReadAhead ahead;
};

TEST(ReadAhead, theNextSectionsAreLoadedOnceEach) {
  Chunks chunks(largeChunks(4));
  EXPECT_FALSE(chunks.has(0)) << "nothing was begun";
  chunks.begin(1);
  chunks.begin(2);
  EXPECT_TRUE(chunks.has(1));
  EXPECT_FALSE(chunks.has(1)) << "it was taken";
  chunks.begin(2);
  chunks.begin(3);
  EXPECT_TRUE(chunks.has(2));
  EXPECT_TRUE(chunks.has(3));
}

TEST(ReadAhead, damageIsTheOutcomeOfItsSectionAlone) {
  Chunks chunks(largeChunks(3));
  Buffer records;
  ++chunks.scanned.index.sections[1].info.compressedBytes;
  chunks.begin(1);
  chunks.begin(2);
  const auto outcome = chunks.ahead.take(1, records);
  ASSERT_TRUE(outcome);
  EXPECT_EQ(problemOf(*outcome), "a chunk's head is damaged");
  EXPECT_TRUE(chunks.has(2));
}

TEST(ReadAhead, whatIsSmallOrTooLargeIsLeftToTheCaller) {
  Chunks small(largeChunks(1, 1000)), large(largeChunks(1), kBytes / 2);
  small.begin(0);
  large.begin(0);
  EXPECT_FALSE(small.has(0));
  EXPECT_FALSE(large.has(0));
}

TEST(ReadAhead, theMemoryOfALargerSectionIsNotKept) {
  Chunks chunks(largeChunks(3));
  Buffer large(2 * kLimit), later;
  chunks.begin(0);
  ASSERT_TRUE(chunks.ahead.take(0, large));
  chunks.begin(1);
  chunks.begin(2);
  ASSERT_TRUE(chunks.ahead.take(2, later));
  EXPECT_LT(later.capacity(), kLimit);
}

TEST(ReadAhead, whatIsNotRequestedAnyMoreGivesWay) {
  Chunks chunks(largeChunks(4));
  chunks.begin(0);
  chunks.begin(1);
  EXPECT_TRUE(eventually([&] {
    chunks.begin(2);  // ignored until the first is loaded
    return chunks.has(2);
  }));
  EXPECT_FALSE(chunks.has(0));
  EXPECT_TRUE(chunks.has(1));
}

TEST(ReadAhead, numbersAreForgottenAndItMayEndWhileItLoads) {
  Chunks chunks(largeChunks(2));
  chunks.begin(0);
  chunks.ahead.forget();
  EXPECT_FALSE(chunks.has(0));
  chunks.begin(1);
}

TEST(ReadAhead, messagesAreListedForWhomTheyWereExpected) {
  const auto channels = std::make_shared<const ChannelSet>(ChannelSet().set(1));
  const auto listingOf = [&](const std::shared_ptr<const ChannelSet>& wanted) {
    Chunks chunks(largeChunks(3));
    chunks.ahead.begin(2, chunks.scanned.index.sections[2], channels);
    Listing listing{wanted, {}, {}};
    Buffer records;
    EXPECT_TRUE(chunks.ahead.take(2, records, &listing));
    return listing;
  };
  const Listing listing = listingOf(channels);
  ASSERT_TRUE(listing.overview);
  EXPECT_EQ(listing.overview->listed, 1U);
  EXPECT_EQ(listing.messages.at(0).time, Instant(std::chrono::nanoseconds(20)));
  EXPECT_FALSE(listingOf(std::make_shared<const ChannelSet>()).overview) << "these are other channels";
}

/// All that a file has and lacks; with a cache of one byte nothing is read ahead.
struct Found {
  explicit Found(const std::filesystem::path& file, Reader::Options options = {}) {
    const auto reader = open(file, std::move(options));
    inFileOrder = readAll(*reader);
    inTimeOrder = readByCursor(*reader);
    const auto readable = reader->verify().value_or(Reader::Readable());
    messages = readable.messages;
    for (const Damage& found : reader->damage()) damage.push_back(std::to_string(found.offset) + found.what);
  }
  std::vector<Expected> inFileOrder, inTimeOrder;
  std::uint64_t messages = 0;
  std::vector<std::string> damage;
  bool operator==(const Found&) const = default;
};

TEST(ReadAhead, readersFindTheSameAsWithoutIt) {
  const TemporaryFolder folder;
  for (const Compression compression : {Compression::kNone, Compression::kLz4, Compression::kZstd}) {
    Writer::Options options;
    options.compression = compression;
    options.chunkBytes = 2 * kBytes;
    const auto file = folder / (std::string(compressionName(compression)) + ".mcap");
    writeLog(file, someMessages(3000, 1000), options);
    EXPECT_EQ(Found(file).messages, 3000U);
    EXPECT_TRUE(Found(file) == Found(file, {.cacheBytes = 1, .progress = {}}));
    std::string bytes = readBytes(file);
    for (const std::size_t place : {bytes.size() / 3, bytes.size() / 2}) bytes[place] ^= 1;
    writeBytes(file, bytes);
    const Found damaged(file);
    EXPECT_THAT(damaged.damage, Not(IsEmpty()));
    EXPECT_THAT(damaged.inFileOrder, Not(IsEmpty()));
    EXPECT_TRUE(damaged == Found(file, {.cacheBytes = 1, .progress = {}}));
  }
}

}  // namespace
