// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <algorithm>

#include "logplayer/mcap/Compression.h"
#include "logplayer/mcap/Crc.h"
#include "logplayer/mcap/RecordBytes.h"
#include "logplayer/mcap/Summary.h"
#include "tests/logplayer/mcap/TemporaryLog.h"

// Files as others may write them, which the conformance suite lacks. Built by the codec.
using namespace logplayer::mcap;
using namespace logplayer::mcap::test;
using testing::ElementsAre;
using testing::IsEmpty;

namespace {

const Schema kSchema{1, "s", "protobuf", "description"};
const Channel kChannels[] = {
    {1, 1, "c1", "protobuf", {}}, {2, 1, "c2", "protobuf", {}}, {3, 0, "c3", "json", {}}};

/// A file being put together record by record.
class HandmadeFile {
 public:
  struct Chunk {
    std::vector<Expected> messages;
    Compression compression = Compression::kNone;
    bool indexed = true;
    bool defines = false;        ///< with the schema and all channels
    bool privateRecord = false;  ///< between messages
  };

  HandmadeFile() : bytes_(std::begin(kMagic), std::end(kMagic)) { encode(bytes_, Header{"", "by hand"}); }

  template <typename Record>
  HandmadeFile& add(const Record& record) {
    encode(bytes_, record);
    return *this;
  }
  HandmadeFile& define() {
    add(kSchema);
    for (const Channel& channel : kChannels) add(channel);
    return *this;
  }
  HandmadeFile& add(const Expected& expected) { return add(messageOf(expected)); }
  HandmadeFile& addPrivate(std::uint8_t opcode, std::size_t length) {
    appendPrivate(bytes_, opcode, length);
    return *this;
  }
  HandmadeFile& add(const Chunk& chunk);
  /// With a summary, or, if not `summary`, cut off.
  void write(const std::filesystem::path& file, bool summary = true);

 private:
  static Message messageOf(const Expected& expected) {
    return {expected.channelId, expected.sequence, at(expected.time), at(expected.time + 1),
            bytesOf(expected.data)};
  }
  static void appendPrivate(Buffer& to, std::uint8_t opcode, std::size_t length) {
    to.push_back(opcode);
    for (int i = 0; i < 8; ++i) to.push_back(static_cast<std::uint8_t>(std::uint64_t{length} >> (8 * i)));
    to.insert(to.end(), length, 0x05);
  }

  Buffer bytes_;
  Summary summary_;
};

HandmadeFile& HandmadeFile::add(const Chunk& chunk) {
  Buffer records;
  if (chunk.defines) encode(records, kSchema);
  for (const Channel& channel : kChannels) {
    if (chunk.defines) encode(records, channel);
  }
  std::map<std::uint16_t, MessageIndex> indexes;
  Instant start{}, end{};
  for (const Expected& expected : chunk.messages) {
    const bool first = &expected == &chunk.messages.front();
    start = first ? at(expected.time) : std::min(start, at(expected.time));
    end = first ? at(expected.time) : std::max(end, at(expected.time));
    MessageIndex& index =
        indexes.try_emplace(expected.channelId, MessageIndex{expected.channelId, {}}).first->second;
    index.entries.push_back({static_cast<std::uint64_t>(expected.time), records.size()});
    encode(records, messageOf(expected));
    if (chunk.privateRecord) appendPrivate(records, 0x80, 33);
    ++summary_.statistics.messageCount;
    ++summary_.statistics.channelMessageCounts[expected.channelId];
  }
  Compressor compressor(chunk.compression, 0);
  const auto compressed = compressor.compress(records);
  const Bytes body = compressed.value_or(records);
  const std::string name(compressionName(compressed ? chunk.compression : Compression::kNone));
  ChunkIndex entry{start, end, bytes_.size(), 0, {}, 0, name, body.size(), records.size()};
  encode(bytes_, ChunkHead{start, end, records.size(), crc32(records), name, body.size()});
  bytes_.insert(bytes_.end(), body.begin(), body.end());
  entry.chunkLength = bytes_.size() - entry.chunkOffset;
  for (const auto& [channel, index] : indexes) {
    if (!chunk.indexed) continue;
    entry.messageIndexOffsets.emplace_back(channel, bytes_.size());
    encode(bytes_, index);
  }
  entry.messageIndexLength = bytes_.size() - entry.chunkOffset - entry.chunkLength;
  summary_.chunks.push_back(std::move(entry));
  ++summary_.statistics.chunkCount;
  return *this;
}

void HandmadeFile::write(const std::filesystem::path& file, bool summary) {
  if (summary) {
    encode(bytes_, DataEnd{});
    summary_.schemas.emplace(1, kSchema);
    for (const Channel& channel : kChannels) summary_.channels.emplace(channel.id, channel);
    summary_.statistics.schemaCount = 1;
    summary_.statistics.channelCount = 3;
    const Buffer end = encodeEnd(summary_, bytes_.size(), true);
    bytes_.insert(bytes_.end(), end.begin(), end.end());
  }
  writeBytes(file, std::string(textOf(bytes_)));
}

/// With and without a summary: both must read the same.
class VectorsTest : public testing::TestWithParam<bool> {
 protected:
  std::unique_ptr<Reader> written(HandmadeFile& file) {
    file.write(folder_ / "log.mcap", GetParam());
    auto reader = test::open(folder_ / "log.mcap");
    EXPECT_EQ(reader->complete(), GetParam());
    return reader;
  }
  /// Nothing is wrong with it but that it may lack its summary.
  static void expectNoLoss(Reader& reader) {
    EXPECT_EQ(readByCursor(reader), readForwards(reader));
    EXPECT_TRUE(reader.verify());
    EXPECT_EQ(reader.damage().size(), reader.complete() ? 0U : 1U);
    for (const Damage& damage : reader.damage()) EXPECT_EQ(damage.bytes, 0U) << damage.what;
  }
  static std::vector<Expected> inOrder(std::vector<Expected> messages) {
    std::ranges::stable_sort(messages, {}, &Expected::time);
    return messages;
  }

  TemporaryFolder folder_;
};

TEST_P(VectorsTest, overlappingChunksAreMerged) {
  const std::vector<Expected> first{{1, 0, 10, "a"}, {2, 1, 40, "b"}, {1, 2, 70, "c"}};
  const std::vector<Expected> second{{2, 3, 20, "d"}, {1, 4, 50, "e"}, {3, 5, 80, "f"}};
  const std::vector<Expected> third{{1, 6, 30, "g"}, {3, 7, 60, "h"}, {2, 8, 90, "i"}};
  HandmadeFile file;
  file.add({first, Compression::kLz4, true, true}).add({second, Compression::kZstd}).add({third});
  const auto reader = written(file);
  std::vector<Expected> all = first;
  all.insert(all.end(), second.begin(), second.end());
  all.insert(all.end(), third.begin(), third.end());
  EXPECT_EQ(readAll(*reader), all);
  EXPECT_EQ(readForwards(*reader), inOrder(all));
  std::vector<Expected> backwards = readBackwards(*reader);
  std::ranges::reverse(backwards);
  EXPECT_EQ(backwards, inOrder(all));
  EXPECT_THAT(reader->times(1), ElementsAre(at(10), at(30), at(50), at(70)));
  EXPECT_EQ(reader->latest(2, at(89))->time, at(40));
  EXPECT_EQ(reader->latest(2, at(90))->time, at(90));
  EXPECT_FALSE(reader->latest(3, at(59)));
  expectNoLoss(*reader);
}

TEST_P(VectorsTest, messagesOutOfOrderWithinAChunkAreSorted) {
  const std::vector<Expected> messages{
      {1, 0, 50, "a"}, {1, 1, 10, "b"}, {2, 2, 50, "c"}, {1, 3, 30, "d"}, {1, 4, 50, "e"}};
  HandmadeFile file;
  file.add({messages, Compression::kNone, true, true});
  const auto reader = written(file);
  EXPECT_EQ(readForwards(*reader), inOrder(messages));
  EXPECT_EQ(reader->read(*reader->latest(1, at(50)))->message.sequence, 4U);
  expectNoLoss(*reader);
}

TEST_P(VectorsTest, anEmptyChunkDoesNoHarm) {
  const std::vector<Expected> messages{{1, 0, 10, "a"}};
  HandmadeFile file;
  file.add({{}, Compression::kNone, true, true}).add({messages}).add(HandmadeFile::Chunk{});
  const auto reader = written(file);
  EXPECT_EQ(reader->chunks().size(), 3U);
  EXPECT_EQ(readForwards(*reader), messages);
  expectNoLoss(*reader);
}

TEST_P(VectorsTest, unknownRecordsAreSkipped) {
  const std::vector<Expected> messages{{1, 0, 10, "a"}, {2, 1, 20, "b"}};
  HandmadeFile file;
  file.addPrivate(0x80, 5).addPrivate(0x10, 0).add({messages, Compression::kNone, true, true, true});
  const HandmadeFile::Chunk later{{{1, 2, 30, "c"}}};
  file.addPrivate(0xFF, 70'000).add(later).addPrivate(0x7F, 9);
  const auto reader = written(file);
  EXPECT_THAT(readForwards(*reader), ElementsAre(messages[0], messages[1], Expected{1, 2, 30, "c"}));
  expectNoLoss(*reader);
}

TEST_P(VectorsTest, aChunkWithoutMessageIndexesIsReadToFindItsMessages) {
  const std::vector<Expected> messages{{1, 0, 20, "a"}, {2, 1, 10, "b"}};
  HandmadeFile file;
  file.add({messages, Compression::kZstd, false, true}).add({{{3, 2, 30, "c"}}, Compression::kLz4, true});
  const auto reader = written(file);
  EXPECT_THAT(readForwards(*reader), ElementsAre(messages[1], messages[0], Expected{3, 2, 30, "c"}));
  EXPECT_EQ(reader->statistics().messageCount, 3U);
  expectNoLoss(*reader);
}

TEST_P(VectorsTest, moreThan65535MessagesFitIntoAChunk) {
  std::vector<Expected> messages;
  for (std::uint32_t i = 0; i < 70'000; ++i)
    messages.push_back({static_cast<std::uint16_t>(1 + i % 3), i, i, {}});
  for (const bool indexed : {true, false}) {
    HandmadeFile file;
    file.add({messages, Compression::kLz4, indexed, true});
    const auto reader = written(file);
    EXPECT_EQ(readForwards(*reader), messages);
    EXPECT_EQ(reader->statistics().messageCount, 70'000U);
    expectNoLoss(*reader);
  }
}

TEST_P(VectorsTest, repeatedSchemasAndChannelsAreOne) {
  HandmadeFile file;
  file.define().add({{{1, 0, 10, "a"}}, Compression::kNone, true, true}).define();
  file.add({{{2, 1, 20, "b"}}, Compression::kNone, true, true});
  const auto reader = written(file);
  EXPECT_EQ(reader->channels().size(), 3U);
  EXPECT_EQ(reader->schemas().size(), 1U);
  EXPECT_EQ(readForwards(*reader).size(), 2U);
  expectNoLoss(*reader);
}

INSTANTIATE_TEST_SUITE_P(Summary, VectorsTest, testing::Bool(),
                         [](const auto& with) { return std::string(with.param ? "with" : "without"); });

TEST(UnchunkedTest, messagesOutsideOfChunksAreReadInOrderOfTime) {
  TemporaryFolder folder;
  std::vector<Expected> messages = someMessages(3000, 1000);  // several stretches
  std::swap(messages[1], messages[2000]);
  HandmadeFile file;
  file.define();
  for (const Expected& message : messages) file.add(message);
  file.add(Metadata{"m", {}});
  file.add(Expected{1, 9999, 5, "behind"});
  messages.push_back({1, 9999, 5, "behind"});
  file.write(folder / "log.mcap", false);
  const auto reader = test::open(folder / "log.mcap");
  EXPECT_EQ(reader->statistics().messageCount, 3001U);
  EXPECT_THAT(reader->chunks(), IsEmpty());
  EXPECT_EQ(readAll(*reader), messages);
  std::ranges::stable_sort(messages, {}, &Expected::time);
  EXPECT_EQ(readForwards(*reader), messages);
}

TEST(UnchunkedTest, readingGoesOnBehindDamage) {
  TemporaryFolder folder;
  const std::vector<Expected> messages = someMessages(100, 100);
  HandmadeFile file;
  file.define();
  for (const Expected& message : messages) file.add(message);
  file.write(folder / "log.mcap", false);
  std::string bytes = readBytes(folder / "log.mcap");
  const std::size_t place = bytes.size() - 131 * 50;  // the head of a message's record
  bytes[place + 5] = '\xFF';
  writeBytes(folder / "log.mcap", bytes);
  const auto reader = test::open(folder / "log.mcap");
  EXPECT_EQ(readAll(*reader).size(), 99U);
  ASSERT_EQ(reader->damage().size(), 2U);
  EXPECT_EQ(reader->damage()[1].bytes, 131U);
}

TEST(CompressionNameTest, anUnknownCompressionIsReportedAndTheRestIsRead) {
  TemporaryFolder folder;
  Writer::Options options;
  options.compression = Compression::kLz4;
  options.chunkBytes = 1000;
  const std::vector<Expected> messages = someMessages(60);
  writeLog(folder / "log.mcap", messages, options);
  std::string bytes = readBytes(folder / "log.mcap");
  const auto chunk = test::open(folder / "log.mcap")->chunks()[1];
  bytes.replace(bytes.find("lz4", chunk.offset), 3, "xyz");
  writeBytes(folder / "cut.mcap", bytes.substr(0, bytes.size() - 8));
  const auto reader = test::open(folder / "cut.mcap");
  EXPECT_EQ(readAll(*reader).size(), messages.size() - chunk.messages);
  ASSERT_FALSE(reader->damage().empty());
  EXPECT_THAT(reader->damage().back().what, testing::HasSubstr("compressed by xyz"));
}

}  // namespace
