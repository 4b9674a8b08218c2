// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/mcap/read/Resync.h"

#include <gtest/gtest.h>

#include "tests/logplayer/mcap/BuiltFile.h"

using namespace logplayer::mcap;
using namespace logplayer::mcap::test;

namespace {

std::optional<Section> chunkIn(const BuiltFile& file, std::uint64_t offset) {
  const Source source = file.source();
  SourceWindow window(source);
  return chunkAt(window, source, offset);
}

bool mayBe(const BuiltFile& file, std::uint64_t offset) {
  const Source source = file.source();
  SourceWindow window(source);
  return recordMayBeAt(window, source, offset);
}

enum class Loose : std::uint8_t { kNo, kYes };

std::optional<std::uint64_t> searched(const BuiltFile& file, std::uint64_t from, Loose loose = Loose::kNo,
                                      const std::map<std::uint16_t, Channel>& channels = {}) {
  const Source source = file.source();
  return Resync(source, 1U << 20U).find(from, loose == Loose::kYes, channels, [](std::uint64_t) {
    return true;
  });
}

TEST(Resync, aChunkIsRecognizedByLengthsThatAgree) {
  BuiltFile file;
  const std::uint64_t offset = file.addChunk({{1, 0, 10, "some"}, {1, 1, 20, "more"}});
  const auto section = chunkIn(file, offset);
  ASSERT_TRUE(section);
  EXPECT_EQ(section->info.offset, offset);
  EXPECT_EQ(section->info.length, file.size() - offset);
  EXPECT_EQ(section->info.start, at(10));
  EXPECT_EQ(section->info.end, at(20));
  EXPECT_EQ(section->unknownCompression, "");
  EXPECT_FALSE(chunkIn(file, offset + 1)) << "there is no opcode";
  file.bytes.pop_back();
  EXPECT_FALSE(chunkIn(file, offset)) << "the file ends before it";
}

TEST(Resync, whatContradictsItselfIsNoChunk) {
  for (const ChunkHead& head : {ChunkHead{at(2), at(1), 4, 0, "", 4},        // ends before it starts
                                ChunkHead{at(1), at(2), 4, 0, "", 5000}}) {  // more records than bytes
    BuiltFile file;
    const std::uint64_t offset = file.add(head);
    file.addBytes(4, 1);
    storeNumber(file.bytes.data() + offset + 1, file.size() - offset - kRecordHeadBytes);
    EXPECT_FALSE(chunkIn(file, offset));
  }
}

TEST(Resync, aChunkOfUnknownCompressionKeepsItsName) {
  BuiltFile file;
  const std::uint64_t offset = file.add(ChunkHead{at(1), at(2), 4, 0, "brotli", 4});
  file.addBytes(4, 1);
  EXPECT_EQ(chunkIn(file, offset)->unknownCompression, "brotli");
  EXPECT_FALSE(searched(file, 0)) << "it cannot be read";
}

TEST(Resync, aRecordMayBeWhereItsOpcodeAndLengthMakeSense) {
  BuiltFile file;
  const std::uint64_t channel = file.add(Channel{1, 0, "c", "", {}});
  EXPECT_TRUE(mayBe(file, channel));
  EXPECT_TRUE(mayBe(file, 0)) << "another file begins there";
  EXPECT_TRUE(mayBe(file, file.size()));
  EXPECT_FALSE(mayBe(file, file.size() + 1));
  EXPECT_FALSE(mayBe(file, file.size() - 3)) << "too short";
  for (const auto& [opcode, expected] :
       {std::pair{0x00, false}, {0x10, false}, {0x7F, false}, {0x80, true}}) {
    file.bytes[channel] = static_cast<std::uint8_t>(opcode);
    EXPECT_EQ(mayBe(file, channel), expected) << opcode;
  }
  storeNumber(file.bytes.data() + channel + 1, std::uint64_t{1} << 40U);
  EXPECT_FALSE(mayBe(file, channel)) << "longer than the file";
}

TEST(Resync, theNextReadableChunkIsFoundWhereverItBegins) {
  BuiltFile file;
  file.addBytes(1000, 0x06);  // the opcode of chunks
  const std::uint64_t first = file.addChunk({{1, 0, 10, "a"}});
  EXPECT_EQ(searched(file, 0), first);
  EXPECT_EQ(searched(file, first), first);
  EXPECT_EQ(searched(file, first + 1), std::nullopt);
  file.addBytes(300U << 10U, 0);
  const std::uint64_t second = file.addChunk({{1, 0, 20, "b"}});
  EXPECT_EQ(searched(file, first + 1), second);
}

TEST(Resync, aChunkWhoseRecordsCannotBeReadIsPassedOver) {
  BuiltFile file;
  const Buffer records = recordsOf({{1, 0, 10, "a"}});
  file.add(ChunkHead{at(1), at(2), records.size(), 12345, "", records.size()});  // its CRC is wrong
  file.bytes.insert(file.bytes.end(), records.begin(), records.end());
  file.addChunk({0xFF, 0xFF, 0xFF}, 1, 2);  // no records
  const std::uint64_t good = file.addChunk({{1, 0, 10, "a"}});
  EXPECT_EQ(searched(file, 0), good);
}

TEST(Resync, messagesCountOnlyOfKnownChannelsAndSeveralInARow) {
  const std::map<std::uint16_t, Channel> known{{1, {}}};
  BuiltFile file;
  const std::uint64_t first = file.addBytes(50, 0xFF);
  const std::uint64_t messages = file.size();
  for (int i = 0; i < 3; ++i) file.add(Message{1, 0, at(i), at(i), bytesOf("data")});
  EXPECT_EQ(searched(file, first, Loose::kYes, known), messages);
  EXPECT_EQ(searched(file, first, Loose::kNo, known), std::nullopt);
  EXPECT_EQ(searched(file, first, Loose::kYes, {{2, {}}}), std::nullopt);

  BuiltFile alone;
  const std::uint64_t one = alone.add(Message{1, 0, at(1), at(1), bytesOf("data")});
  alone.addBytes(50, 0xFF);
  EXPECT_EQ(searched(alone, one, Loose::kYes, known), std::nullopt) << "garbage follows a single one";
}

TEST(Resync, itNotesWhereTheLastByteIsThatIsNotZeroAndCanBeCanceled) {
  BuiltFile file;
  const std::uint64_t garbage = file.addBytes(10, 0xFF);
  file.addBytes(1U << 20U, 0);
  const Source source = file.source();
  Resync resync(source, 1U << 20U);
  EXPECT_FALSE(resync.find(garbage, false, {}, [](std::uint64_t) { return true; }));
  EXPECT_EQ(resync.dataEnd(), garbage + 10);
  int calls = 0;
  EXPECT_FALSE(resync.find(garbage, false, {}, [&](std::uint64_t) { return ++calls < 3; }));
  EXPECT_EQ(calls, 3);
}

}  // namespace
