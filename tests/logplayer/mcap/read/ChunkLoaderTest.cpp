// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/mcap/read/ChunkLoader.h"

#include <gmock/gmock.h>

#include "logplayer/mcap/Crc.h"
#include "logplayer/mcap/read/Resync.h"
#include "tests/logplayer/mcap/BuiltFile.h"

using namespace logplayer::mcap;
using namespace logplayer::mcap::test;
using testing::HasSubstr;

namespace {

/// The records that are loaded of a chunk, or what is wrong with it.
std::string loaded(const BuiltFile& file, const Section& section, std::size_t limit = 1U << 20U) {
  const Source source = file.source();
  Buffer records;
  const auto result = ChunkLoader(source, limit).load(section, records);
  return result ? std::string(textOf(records)) : "problem: " + result.error();
}

std::string loaded(const BuiltFile& file, std::uint64_t offset, std::size_t limit = 1U << 20U) {
  const Source source = file.source();
  SourceWindow window(source);
  const auto section = chunkAt(window, source, offset);
  return section ? loaded(file, *section, limit) : "no chunk";
}

/// A file with one chunk, which is compressed, and where it begins.
struct CompressedFile : BuiltFile {
  explicit CompressedFile(Compression compression) {
    Compressor compressor(compression, 0);
    const Bytes packed =
        compression == Compression::kNone ? bytesOf(text) : compressor.compress(bytesOf(text)).value();
    offset = add(ChunkHead{at(1), at(2), text.size(), crc32(bytesOf(text)),
                           std::string(compressionName(compression)), packed.size()});
    bytes.insert(bytes.end(), packed.begin(), packed.end());
  }
  std::string text = std::string(5000, 'a') + std::string(5000, 'b');
  std::uint64_t offset = 0;
};

TEST(ChunkLoader, recordsAreDecompressedAndTheirCrcIsChecked) {
  for (const Compression compression : {Compression::kNone, Compression::kLz4, Compression::kZstd}) {
    CompressedFile file(compression);
    EXPECT_EQ(loaded(file, file.offset), file.text);
    file.bytes[file.offset + kRecordHeadBytes + 24] ^= 1U;
    EXPECT_EQ(loaded(file, file.offset), "problem: the CRC of a chunk is wrong");
  }
}

TEST(ChunkLoader, aDamagedChunkIsRefusedWithTheReason) {
  CompressedFile file(Compression::kZstd);
  EXPECT_THAT(loaded(file, file.offset, 9999), HasSubstr("claims 10000 bytes, more than the limit of 9999"));
  const std::size_t records = file.offset + kRecordHeadBytes + chunkHeadBytes(4);
  Buffer whole = file.bytes;
  file.bytes[records + 12] ^= 0xFFU;
  EXPECT_THAT(loaded(file, file.offset), HasSubstr("problem: "));
  file.bytes = std::move(whole);
  storeNumber(file.bytes.data() + file.offset + kRecordHeadBytes + 16, std::uint64_t{9999});
  EXPECT_THAT(loaded(file, file.offset), HasSubstr("bytes of only"));
}

TEST(ChunkLoader, itLoadsOnlyWhatTheSectionSays) {
  BuiltFile file;
  const std::uint64_t offset = file.addChunk({{1, 0, 10, "data"}});
  const Source source = file.source();
  SourceWindow window(source);
  const Section section = *chunkAt(window, source, offset);
  const auto after = [&](const std::function<void(Section&)>& change) {
    Section changed = section;
    change(changed);
    return loaded(file, changed);
  };
  EXPECT_EQ(after([](Section&) {}), textOf(recordsOf({{1, 0, 10, "data"}})));
  EXPECT_EQ(after([](Section& other) { ++other.info.offset; }), "problem: the file ends within a chunk");
  EXPECT_EQ(after([](Section& other) { --other.info.offset; }),
            "problem: there is no chunk where the file says so");
  EXPECT_EQ(after([](Section& other) { ++other.info.compressedBytes; }),
            "problem: a chunk's head is damaged");
  EXPECT_EQ(after([](Section& other) { other.info.compression = Compression::kLz4; }),
            "problem: a chunk's head is damaged");
  EXPECT_THAT(after([](Section& other) { other.unknownCompression = "brotli"; }),
              HasSubstr("compressed by brotli, which is not supported here"));
}

TEST(ChunkLoader, recordsAreVisitedUntilTheyBreakOff) {
  Buffer records = recordsOf({{1, 0, 10, "a"}, {2, 0, 20, "bc"}});
  std::vector<std::size_t> offsets;
  const auto note = [&](const RecordView&, std::size_t offset) { offsets.push_back(offset); };
  EXPECT_TRUE(visitRecords(records, note));
  EXPECT_EQ(offsets, (std::vector<std::size_t>{0, kMessageHeadBytes + 1}));
  records.pop_back();
  offsets.clear();
  EXPECT_FALSE(visitRecords(records, note));
  EXPECT_EQ(offsets.size(), 1U);
}

}  // namespace
