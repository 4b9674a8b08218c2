// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <random>

#include "logplayer/mcap/Codec.h"
#include "logplayer/mcap/Compression.h"
#include "logplayer/mcap/Crc.h"
#include "logplayer/mcap/RecordBytes.h"

using namespace logplayer::mcap;

namespace {

/// Each byte `repeated` times.
std::vector<std::uint8_t> randomBytes(std::size_t count, std::size_t repeated = 1) {
  std::minstd_rand random(7);
  std::vector<std::uint8_t> bytes(count);
  for (std::size_t i = 0; i < count; ++i) {
    bytes[i] = i % repeated == 0 ? static_cast<std::uint8_t>(random() >> 8U) : bytes[i - 1];
  }
  return bytes;
}

TEST(CrcTest, isThatOfTheStandardsCheckValue) {
  EXPECT_EQ(crc32(bytesOf("123456789")), 0xCBF43926U);
}

TEST(CrcTest, goesOnFromWhatWasBefore) {
  EXPECT_EQ(crc32(bytesOf("6789"), crc32(bytesOf("12345"))), 0xCBF43926U);
  EXPECT_EQ(crc32({}, 77), 77U);
}

TEST(CrcTest, ofTwoStretchesIsJoinedFromTheirOwn) {
  const std::vector<std::uint8_t> bytes = randomBytes(100'000);
  for (const std::size_t split :
       {std::size_t{0}, std::size_t{1}, std::size_t{4096}, bytes.size() - 1, bytes.size()}) {
    const Bytes first = Bytes(bytes).first(split);
    const Bytes second = Bytes(bytes).subspan(split);
    EXPECT_EQ(joinedCrc32(crc32(first), crc32(second), second.size()), crc32(bytes)) << split;
  }
}

TEST(CodecTest, timesThatDoNotFitBecomeTheNearestThatDo) {
  EXPECT_EQ(instantOf(UINT64_MAX), Instant::max());
  EXPECT_EQ(instantOf(5), Instant(robotlink::Duration(5)));
  EXPECT_EQ(nanosecondsOf(Instant(robotlink::Duration(-5))), 0U);
}

TEST(CodecTest, aRecordCutAnywhereIsNotDecoded) {
  Buffer bytes;
  encode(bytes, Channel{1, 2, "topic", "json", {{"key", "value"}}});
  const Bytes content = firstRecord(bytes)->content;
  for (std::size_t length = 0; length < content.size(); ++length) {
    EXPECT_FALSE(decode<Channel>(content.first(length))) << length;
    EXPECT_FALSE(firstRecord(Bytes(bytes).first(length)));
  }
  EXPECT_EQ(decode<Channel>(content)->metadata.at("key"), "value");
}

TEST(CodecTest, whatFollowsTheKnownFieldsIsIgnored) {
  Buffer bytes;
  const std::uint8_t padding[] = {1, 2, 3};
  const Metadata metadata{"m", {{"a", "b"}}};
  encode(bytes, metadata, padding);
  EXPECT_EQ(bytes.size(), kRecordHeadBytes + 4 + 1 + 4 + 10 + 3);
  EXPECT_EQ(decode<Metadata>(firstRecord(bytes)->content).value(), metadata);
}

TEST(CodecTest, aLengthPastTheEndIsNotBelieved) {
  Buffer bytes;
  encode(bytes, MessageIndex{1, {{10, 20}}});
  bytes[kRecordHeadBytes + 2 + 3] = 0xFF;
  EXPECT_FALSE(decodeMessageIndex(firstRecord(bytes)->content));
}

TEST(CodecTest, schemaZeroIsInvalid) {
  Buffer bytes;
  encode(bytes, Schema{0, "s", "", ""});
  EXPECT_FALSE(decode<Schema>(firstRecord(bytes)->content));
}

TEST(CompressionTest, whatIsCompressedComesBack) {
  for (const Compression compression : {Compression::kLz4, Compression::kZstd}) {
    for (const std::size_t size : {std::size_t{100}, std::size_t{3'000'000}}) {
      const std::vector<std::uint8_t> bytes = randomBytes(size, 50);
      Compressor compressor(compression, 0);
      const auto compressed = compressor.compress(bytes);
      ASSERT_TRUE(compressed);
      EXPECT_LT(compressed->size(), size);
      std::vector<std::uint8_t> back(size);
      EXPECT_TRUE(Decompressor().decompress(compression, *compressed, back));
      EXPECT_EQ(back, bytes);
    }
  }
}

TEST(CompressionTest, whatDoesNotGetSmallerIsNotCompressed) {
  for (const Compression compression : {Compression::kNone, Compression::kLz4, Compression::kZstd}) {
    EXPECT_FALSE(Compressor(compression, 0).compress(randomBytes(10'000)));
  }
}

TEST(CompressionTest, anotherSizeThanPromisedIsRefused) {
  const std::vector<std::uint8_t> bytes = randomBytes(10'000, 50);
  for (const Compression compression : {Compression::kLz4, Compression::kZstd}) {
    Compressor compressor(compression, 0);
    const Bytes compressed = compressor.compress(bytes).value();
    Decompressor decompressor;
    std::vector<std::uint8_t> tooSmall(9'999), tooLarge(10'001), right(10'000);
    EXPECT_FALSE(decompressor.decompress(compression, compressed, tooSmall));
    EXPECT_FALSE(decompressor.decompress(compression, compressed, tooLarge));
    EXPECT_FALSE(decompressor.decompress(compression, compressed.first(compressed.size() - 1), right));
    EXPECT_TRUE(decompressor.decompress(compression, compressed, right));
    EXPECT_EQ(right, bytes);
  }
}

}  // namespace
