// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>

#include "logplayer/mcap/Codec.h"
#include "logplayer/mcap/Compression.h"
#include "logplayer/mcap/RecordBytes.h"
#include "tests/logplayer/mcap/Allocations.h"
#include "tests/logplayer/mcap/TemporaryLog.h"

// Whatever happens to a file: it is read without a crash, within the bound of memory, and all is there but
// what was in the chunk that was hit. The quick form hits a file of a few chunks at all its bytes; the slow
// one (ROBOTCONTROL_SLOW_TESTS, see CMakeLists.txt) one of 64 KiB.
using namespace logplayer::mcap;
using namespace logplayer::mcap::test;

namespace {

bool isSlow() {
  return std::getenv("ROBOTCONTROL_SLOW_TESTS") != nullptr;
}

class DamageTest : public testing::TestWithParam<Compression> {
 protected:
  static constexpr std::size_t kCacheBytes = 1U << 20U;
  static constexpr std::size_t kMaxRecordBytes = 4U << 20U;

  void SetUp() override {
    Writer::Options options;
    options.compression = GetParam();
    options.chunkBytes = isSlow() ? 8000 : 500;
    messages_ = isSlow() ? someMessages(480, 80) : someMessages(32, 16);
    writeLog(log_, messages_, options);
    bytes_ = readBytes(log_);
    chunks_ = test::open(log_)->chunks();
    ASSERT_LE(bytes_.size(), 65536U);
    ASSERT_GT(chunks_.size(), 3U);
  }

  static Reader::Options options() {
    Reader::Options options;
    options.cacheBytes = kCacheBytes;
    options.maxRecordBytes = kMaxRecordBytes;
    return options;
  }
  /// The bound: the cache, an index of about the file's size, two of the largest records (compressed and
  /// not), and what the libraries take for themselves.
  std::size_t bound() const {
    return kCacheBytes * 5 / 4 + 8 * bytes_.size() + 2 * kMaxRecordBytes + (1U << 20U);
  }

  struct Outcome {
    bool opened = false;
    std::vector<Expected> forwards, byCursor, all;
    std::vector<Damage> damage;
  };
  /// Reads a file in every way.
  Outcome readDamaged(const std::string& bytes) {
    writeBytes(folder_ / "damaged.mcap", bytes);
    const LargestAllocation largest;
    Outcome outcome;
    const auto reader = Reader::open(folder_ / "damaged.mcap", options());
    if (reader) {
      outcome.opened = true;
      outcome.forwards = readForwards(**reader);
      outcome.byCursor = readByCursor(**reader);
      outcome.all = readAll(**reader);
      for (const auto& [id, channel] : (*reader)->channels()) (*reader)->times(id);
      EXPECT_TRUE((*reader)->verify());
      outcome.damage = (*reader)->damage();
    }
    EXPECT_LE(largest.bytes(), bound());
    return outcome;
  }
  /// The number of the chunk that a byte belongs to, its indexes included; none for what is in front of them.
  std::optional<std::size_t> chunkOf(std::size_t byte) const {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < chunks_.size(); ++i) {
      if (byte >= chunks_[i].offset) found = i;
    }
    return found;
  }
  std::vector<Expected> without(std::optional<std::size_t> chunk) const {
    if (!chunk) return messages_;
    std::vector<Expected> left;
    std::ranges::copy_if(messages_, std::back_inserter(left), [&](const Expected& message) {
      return at(message.time) < chunks_[*chunk].start || at(message.time) > chunks_[*chunk].end;
    });
    return left;
  }
  static bool containsAll(const std::vector<Expected>& found, const std::vector<Expected>& expected) {
    const auto inOrder = [](const Expected& a, const Expected& b) { return a.time < b.time; };
    return std::ranges::includes(found, expected, inOrder) &&
           std::ranges::all_of(expected, [&](const Expected& one) {
             return *std::ranges::lower_bound(found, one, inOrder) == one;
           });
  }
  void flipAll(const std::string& bytes, std::size_t step, std::size_t from = 0) {
    for (std::size_t i = from; i < bytes.size(); i += step) {
      std::string flipped = bytes;
      flipped[i] = static_cast<char>(flipped[i] ^ (1 << (i % 8)));
      const Outcome outcome = readDamaged(flipped);
      ASSERT_TRUE(outcome.opened) << "byte " << i;
      ASSERT_FALSE(outcome.damage.empty()) << "byte " << i;
      const std::vector<Expected> left = without(chunkOf(i));
      ASSERT_TRUE(containsAll(outcome.forwards, left)) << "byte " << i;
      ASSERT_TRUE(containsAll(outcome.byCursor, left)) << "byte " << i;
      ASSERT_TRUE(containsAll(outcome.all, left)) << "byte " << i;
    }
  }

  TemporaryFolder folder_;
  std::filesystem::path log_ = folder_ / "log.mcap";
  std::vector<Expected> messages_;
  std::string bytes_;
  std::vector<Reader::ChunkInfo> chunks_;
};

TEST_P(DamageTest, aFileCutAtAnyByteKeepsAllChunksBeforeThat) {
  for (std::size_t length = 0; length < bytes_.size(); ++length) {
    const Outcome outcome = readDamaged(bytes_.substr(0, length));
    std::vector<Expected> expected;
    for (std::size_t i = 0; i < chunks_.size(); ++i) {
      if (chunks_[i].offset + chunks_[i].length > length) break;
      for (const Expected& message : messages_) {
        if (at(message.time) >= chunks_[i].start && at(message.time) <= chunks_[i].end)
          expected.push_back(message);
      }
    }
    ASSERT_EQ(outcome.opened, length >= sizeof kMagic) << length;
    ASSERT_EQ(outcome.forwards, expected) << "cut to " << length;
    ASSERT_EQ(outcome.all, expected) << "cut to " << length;
    ASSERT_EQ(outcome.damage.empty(), !outcome.opened);
  }
}

TEST_P(DamageTest, theSearchBehindDamageReportsItsProgressAndCanBeCanceled) {
  const auto file = folder_ / "hole.mcap";
  const std::size_t cut = chunks_.back().offset;
  writeBytes(file, bytes_.substr(0, cut));
  std::filesystem::resize_file(file, cut + (40U << 20U));
  int expected = 0;
  Reader::Options chosen = options();
  chosen.progress = [&](double share) {
    EXPECT_LE(share, 1);
    return ++expected != 5;
  };
  const auto reader = Reader::open(file, chosen);
  EXPECT_EQ(expected, 5);
  ASSERT_FALSE(reader);
  EXPECT_EQ(reader.error().id, "log.given-up");
  EXPECT_EQ(test::open(file, chosen)->chunks().size(), chunks_.size() - 1);
  EXPECT_GT(expected, 12);
}

TEST_P(DamageTest, aFlippedByteCostsAtMostItsChunk) {
  flipAll(bytes_, 1);
}

TEST_P(DamageTest, aFlippedByteCostsAtMostItsChunkAlsoWithoutSummary) {
  const std::size_t dataEnd = chunks_.back().offset + chunks_.back().length;
  flipAll(bytes_.substr(0, dataEnd), 1, sizeof kMagic);
}

INSTANTIATE_TEST_SUITE_P(Compressions, DamageTest,
                         testing::Values(Compression::kNone, Compression::kLz4, Compression::kZstd));

/// A file with one chunk whose head says what the test wants it to.
class LyingChunkTest : public testing::Test {
 protected:
  std::unique_ptr<Reader> readerOf(ChunkHead head, Bytes body, std::uint64_t recordLength = 0) {
    Buffer bytes(std::begin(kMagic), std::end(kMagic));
    encode(bytes, Header{});
    encode(bytes, Channel{1, 0, "c1", "", {}});
    const std::size_t chunk = bytes.size();
    encode(bytes, head);
    if (recordLength != 0) storeNumber(bytes.data() + chunk + 1, recordLength);
    bytes.insert(bytes.end(), body.begin(), body.end());
    encode(bytes, MessageIndex{1, {{5, 0}}});
    writeBytes(folder_ / "log.mcap", std::string(textOf(bytes)));
    return test::open(folder_ / "log.mcap", {});
  }
  /// Nothing of it can be read, that is reported, and no more memory was taken than `bytes`.
  static void expectNothing(Reader& reader) {
    EXPECT_TRUE(readForwards(reader, {1}).empty());
    EXPECT_TRUE(readAll(reader).empty());
    EXPECT_GE(reader.damage().size(), 2U);
  }

  static constexpr std::size_t kLittle = 4U << 20U;
  TemporaryFolder folder_;
  std::vector<std::uint8_t> body_ = std::vector<std::uint8_t>(500, 7);
};

TEST_F(LyingChunkTest, oneThatClaimsHugeRecordsIsLeftOut) {
  const LargestAllocation largest;
  for (const std::uint64_t claim :
       {std::uint64_t{1} << 63U, std::uint64_t{UINT64_MAX}, std::uint64_t{1} << 40U}) {
    expectNothing(*readerOf({at(5), at(5), claim, 0, "zstd", body_.size()}, body_));
    expectNothing(*readerOf({at(5), at(5), claim, 0, "lz4", body_.size()}, body_));
    expectNothing(*readerOf({at(5), at(5), claim, 0, "", body_.size()}, body_));
    expectNothing(*readerOf({at(5), at(5), 500, 0, "", claim}, body_));
    expectNothing(*readerOf({at(5), at(5), 500, 0, "", body_.size()}, body_, claim));
  }
  EXPECT_LE(largest.bytes(), kLittle);
}

TEST_F(LyingChunkTest, noMemoryIsTakenForMoreThanItCanBecome) {
  const LargestAllocation largest;
  const std::uint64_t claim = 512U << 20U;  // within the limit of a reader
  for (const Compression compression : {Compression::kLz4, Compression::kZstd}) {
    Compressor compressor(compression, 0);
    const Bytes honest = compressor.compress(body_).value();
    const std::string name(compressionName(compression));
    expectNothing(*readerOf({at(5), at(5), claim, 0, name, honest.size()}, honest));
    EXPECT_TRUE(Decompressor::canYield(compression, honest, body_.size()));
  }
  EXPECT_LE(largest.bytes(), kLittle);
}

TEST_F(LyingChunkTest, aBombIsNotInflatedPastWhatItClaims) {
  const std::vector<std::uint8_t> zeros(64U << 20U);
  for (const Compression compression : {Compression::kLz4, Compression::kZstd}) {
    Compressor compressor(compression, 0);
    const Bytes bomb = compressor.compress(zeros).value();
    const LargestAllocation largest;
    expectNothing(
        *readerOf({at(5), at(5), 1000, 0, std::string(compressionName(compression)), bomb.size()}, bomb));
    EXPECT_LE(largest.bytes(), kLittle + 4 * bomb.size());
  }
}

TEST_F(LyingChunkTest, aBombThatSaysSoIsNotInflatedPastTheLimit) {
  const std::vector<std::uint8_t> zeros(64U << 20U);
  Compressor compressor(Compression::kZstd, 0);
  const Bytes bomb = compressor.compress(zeros).value();
  static_cast<void>(readerOf({at(5), at(5), zeros.size(), 0, "zstd", bomb.size()}, bomb));
  const LargestAllocation largest;
  Reader::Options options;
  options.maxRecordBytes = 1U << 20U;
  expectNothing(*test::open(folder_ / "log.mcap", options));
  EXPECT_LE(largest.bytes(), kLittle);
}

}  // namespace
