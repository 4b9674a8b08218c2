// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <algorithm>
#include <tuple>

#include "logplayer/mcap/RecordBytes.h"
#include "tests/logplayer/mcap/TemporaryLog.h"

using namespace logplayer::mcap;
using namespace logplayer::mcap::test;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

namespace {

class RepairTest : public testing::Test {
 protected:
  void SetUp() override {
    Writer::Options options;
    options.chunkBytes = 1000;
    options.compression = Compression::kLz4;
    options.profile = "p";
    auto writer = Writer::create(whole_, options);
    ASSERT_TRUE(writer);
    addChannels(**writer, 3);
    for (const Expected& message : messages_) write(**writer, message);
    ASSERT_TRUE((*writer)->attach({at(1), at(2), "notes", "text/plain", "some"}));
    ASSERT_TRUE((*writer)->addMetadata({"m", {{"a", "b"}}}));
    ASSERT_TRUE((*writer)->close());
    bytes_ = readBytes(whole_);
    chunks_ = test::open(whole_)->chunks();
  }
  /// All messages but those in some chunk, given its number.
  std::vector<Expected> without(std::size_t chunk) const {
    std::vector<Expected> left;
    for (const Expected& message : messages_) {
      const Instant time = at(message.time);
      if (time < chunks_[chunk].start || time > chunks_[chunk].end) left.push_back(message);
    }
    return left;
  }

  TemporaryFolder folder_;
  std::filesystem::path whole_ = folder_ / "whole.mcap";
  std::filesystem::path broken_ = folder_ / "broken.mcap";
  std::filesystem::path repaired_ = folder_ / "repaired.mcap";
  std::vector<Expected> messages_ = someMessages(200);
  std::string bytes_;
  std::vector<Reader::ChunkInfo> chunks_;
};

TEST_F(RepairTest, aWholeFileIsCopied) {
  const auto report = repair(whole_, repaired_);
  ASSERT_TRUE(report) << report.error().describe();
  EXPECT_EQ(report->messages, 200U);
  EXPECT_EQ(report->bytesLost, 0U);
  EXPECT_THAT(report->damage, IsEmpty());
  const auto reader = test::open(repaired_);
  EXPECT_EQ(readAll(*reader), messages_);
  EXPECT_EQ(reader->chunks().size(), chunks_.size());
  EXPECT_EQ(reader->header().profile, "p");
  EXPECT_EQ(reader->attachment("notes").value().data, "some");
  EXPECT_THAT(reader->metadata(), SizeIs(1));
}

TEST_F(RepairTest, aCutFileBecomesComplete) {
  writeBytes(broken_, bytes_.substr(0, chunks_[5].offset + 100));
  const auto report = repair(broken_, repaired_);
  ASSERT_TRUE(report) << report.error().describe();
  EXPECT_EQ(report->bytesLost, 100U);
  EXPECT_EQ(report->chunksLost, 1U);
  const auto reader = test::open(repaired_);
  EXPECT_TRUE(reader->complete());
  EXPECT_EQ(reader->chunks().size(), 5U);
  EXPECT_EQ(readAll(*reader).size(), report->messages);
  EXPECT_EQ(reader->statistics().messageCount, report->messages);
}

TEST_F(RepairTest, aDamagedChunkIsLeftOutAndCounted) {
  bytes_[chunks_[3].offset + chunks_[3].length - 20] ^= 0x10;
  writeBytes(broken_, bytes_);
  const auto report = repair(broken_, repaired_);
  ASSERT_TRUE(report) << report.error().describe();
  EXPECT_EQ(report->chunksLost, 1U);
  EXPECT_EQ(report->bytesLost, chunks_[3].length);
  EXPECT_EQ(readAll(*test::open(repaired_)), without(3));
}

TEST_F(RepairTest, theFirstChunkMayBeTheDamagedOneOfACutFile) {
  bytes_[chunks_[0].offset + chunks_[0].length - 20] ^= 0x10;
  writeBytes(broken_, bytes_.substr(0, bytes_.size() - 30));
  ASSERT_TRUE(repair(broken_, repaired_));
  const auto reader = test::open(repaired_);
  EXPECT_EQ(readAll(*reader), without(0));
  EXPECT_EQ(reader->channels().size(), 3U);
}

TEST_F(RepairTest, aFileThatExistsIsNotTouched) {
  writeBytes(repaired_, "mine");
  EXPECT_FALSE(repair(whole_, repaired_));
  EXPECT_EQ(readBytes(repaired_), "mine");
}

TEST_F(RepairTest, givenUpNothingIsLeft) {
  double last = 0;
  const auto giveUp = [&](double share) {
    EXPECT_GE(share, last);
    last = share;
    return share < 0.3;
  };
  const auto report = repair(whole_, repaired_, giveUp);
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().id, "log.given-up");
  EXPECT_FALSE(std::filesystem::exists(repaired_));
}

TEST_F(RepairTest, whatIsNoMcapFileIsRefused) {
  writeBytes(broken_, std::string(5000, 'x'));
  const auto report = repair(broken_, repaired_);
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().id, "mcap.none");
  EXPECT_FALSE(std::filesystem::exists(repaired_));
  EXPECT_FALSE(repair(folder_ / "missing", repaired_));
}

using VerifyTest = RepairTest;

TEST_F(VerifyTest, aWholeFileHasNoDamage) {
  const auto reader = test::open(whole_);
  EXPECT_TRUE(reader->verify());
  EXPECT_THAT(reader->damage(), IsEmpty());
}

TEST_F(VerifyTest, everyFlippedBitIsFound) {
  for (std::size_t i = 0; i < bytes_.size(); i += 7) {
    std::string flipped = bytes_;
    flipped[i] ^= 0x40;
    writeBytes(broken_, flipped);
    const auto reader = Reader::open(broken_, {});
    if (!reader) continue;
    EXPECT_TRUE((*reader)->verify());
    EXPECT_FALSE((*reader)->damage().empty()) << "byte " << i;
  }
}

TEST_F(VerifyTest, itCanBeGivenUp) {
  Reader::Options options;
  options.progress = [](double share) { return share < 0.2; };
  EXPECT_FALSE(test::open(whole_, options)->verify());
}

TEST_F(VerifyTest, aWrongMessageIndexIsReportedAndDoneWithout) {
  // The offset in the first entry of the message index behind the third chunk.
  bytes_[chunks_[2].offset + chunks_[2].length + 9 + 2 + 4 + 8] ^= 0x04;
  writeBytes(broken_, bytes_);
  const auto reader = test::open(broken_);
  EXPECT_TRUE(reader->verify());
  ASSERT_THAT(reader->damage(), SizeIs(1));
  EXPECT_THAT(reader->damage()[0].what, HasSubstr("message indexes"));
  EXPECT_EQ(readForwards(*reader), messages_);
}

/// What chunks and their message indexes are in the file, one behind the other.
class MisfitTest : public RepairTest {
 protected:
  std::size_t endOf(std::size_t chunk) const {
    if (chunk + 1 < chunks_.size()) return chunks_[chunk + 1].offset;
    // The record behind the data section.
    std::string end{0x0F, 4, 0, 0, 0, 0, 0, 0, 0};
    return bytes_.find(end, chunks_[chunk].offset + chunks_[chunk].length);
  }
  std::string part(std::size_t chunk) const {
    return bytes_.substr(chunks_[chunk].offset, endOf(chunk) - chunks_[chunk].offset);
  }
  /// Two chunks change their places; the summary does not know.
  void swap(std::size_t a, std::size_t b) {
    const std::string swapped = bytes_.substr(0, chunks_[a].offset) + part(b) +
                                bytes_.substr(endOf(a), chunks_[b].offset - endOf(a)) + part(a) +
                                bytes_.substr(endOf(b));
    ASSERT_EQ(swapped.size(), bytes_.size());
    writeBytes(broken_, swapped);
  }
  static std::vector<Expected> sorted(std::vector<Expected> messages) {
    std::ranges::sort(messages, {}, &Expected::time);
    return messages;
  }
};

TEST_F(MisfitTest, aSummaryThatDoesNotFitIsNotBelieved) {
  ASSERT_GE(chunks_.size(), 10U);
  ASSERT_NE(part(1).size(), part(7).size());
  swap(1, 7);
  const auto reader = test::open(broken_);
  EXPECT_EQ(readForwards(*reader), messages_);
  EXPECT_EQ(readBackwards(*reader).size(), messages_.size());
  EXPECT_EQ(sorted(readAll(*reader)), messages_);
  EXPECT_EQ(reader->statistics().messageCount, messages_.size());
  EXPECT_FALSE(reader->complete());
  const auto readable = reader->verify();
  ASSERT_TRUE(readable);
  EXPECT_EQ(readable->messages, messages_.size());
  ASSERT_THAT(reader->damage(), SizeIs(1));
  EXPECT_THAT(reader->damage()[0].what, HasSubstr("summary does not fit"));
}

TEST_F(MisfitTest, nothingIsLostInARepairOfIt) {
  swap(1, 7);
  const auto report = repair(broken_, repaired_);
  ASSERT_TRUE(report) << report.error().describe();
  EXPECT_EQ(report->messages, messages_.size());
  EXPECT_EQ(report->chunksLost, 0U);
  EXPECT_EQ(report->bytesLost, 0U);
  EXPECT_EQ(readForwards(*test::open(repaired_)), messages_);
}

TEST_F(VerifyTest, itCountsWhatCanBeReadNotWhatTheSummarySays) {
  bytes_[chunks_[3].offset + chunks_[3].length - 20] ^= 0x10;
  writeBytes(broken_, bytes_);
  const auto reader = test::open(broken_);
  const auto readable = reader->verify();
  ASSERT_TRUE(readable);
  EXPECT_EQ(readable->messages, without(3).size());
  EXPECT_EQ(readable->chunks, chunks_.size() - 1);
}

/// Many chunks, so that not all of them are looked for when the file is opened; equally long ones.
class ManyChunksTest : public MisfitTest {
 protected:
  void SetUp() override {
    Writer::Options options;
    options.chunkBytes = 100'000;
    std::vector<std::size_t> flushes;
    messages_.clear();
    for (std::size_t i = 0; i < 600; ++i) {
      const auto id = static_cast<std::uint16_t>(1 + i % 3);
      messages_.push_back({id, static_cast<std::uint32_t>(i), static_cast<std::int64_t>(10 * i),
                           std::string(i < 450 ? 40 : 50, 'x')});
      if (i % 6 == 0) flushes.push_back(i);
    }
    writeLog(whole_, messages_, options, flushes);
    bytes_ = readBytes(whole_);
    chunks_ = test::open(whole_)->chunks();
    ASSERT_EQ(chunks_.size(), 100U);
  }
};

TEST_F(ManyChunksTest, chunksThatAreAsLongAsEachOtherMayChangePlaces) {
  ASSERT_EQ(part(11).size(), part(67).size());
  swap(11, 67);
  const auto reader = test::open(broken_);
  EXPECT_EQ(readForwards(*reader), messages_);
  EXPECT_EQ(readBackwards(*reader).size(), messages_.size());
  EXPECT_EQ(sorted(readAll(*reader)), messages_);
}

TEST_F(ManyChunksTest, whatIsFoundOnlyWhileItIsReadIsReadToo) {
  for (const auto& [a, b] : {std::pair{13, 79}, {76, 98}, {77, 78}}) {
    swap(static_cast<std::size_t>(a), static_cast<std::size_t>(b));
    EXPECT_EQ(readForwards(*test::open(broken_)), messages_) << a << " " << b;
    EXPECT_EQ(readBackwards(*test::open(broken_)).size(), messages_.size()) << a << " " << b;
    EXPECT_EQ(sorted(readAll(*test::open(broken_))), messages_) << a << " " << b;
    std::size_t times = 0;
    const auto reader = test::open(broken_);
    for (const auto& [id, channel] : reader->channels()) times += reader->times(id).size();
    EXPECT_EQ(times, messages_.size());
    const auto verified = test::open(broken_)->verify();
    EXPECT_EQ(verified->messages, messages_.size());
    const auto report = repair(broken_, repaired_);
    ASSERT_TRUE(report);
    EXPECT_EQ(report->messages, messages_.size());
    std::filesystem::remove(repaired_);
  }
}

TEST_F(ManyChunksTest, oneDamagedHeadDoesNotMakeTheSummaryALiar) {
  bytes_[chunks_[50].offset + 9 + 16] ^= 0x10;  // what it says of its size
  writeBytes(broken_, bytes_);
  const auto reader = test::open(broken_);
  EXPECT_EQ(readAll(*reader), without(50));
  ASSERT_TRUE(reader->verify());
  for (const Damage& damage : reader->damage())
    EXPECT_EQ(damage.what.find("summary"), std::string::npos) << damage.what;
}

/// Chunks of robots' logs, larger than what is missing of one.
class MissingPartTest : public testing::TestWithParam<std::tuple<Compression, std::size_t>> {
 protected:
  TemporaryFolder folder_;
};

TEST_P(MissingPartTest, costsOneChunk) {
  const auto [compression, missing] = GetParam();
  const std::vector<Expected> messages = someMessages(4000, 100);
  Writer::Options options;
  options.compression = compression;
  options.chunkBytes = 100'000;
  writeLog(folder_ / "whole.mcap", messages, options);
  const std::string bytes = readBytes(folder_ / "whole.mcap");
  const auto chunks = test::open(folder_ / "whole.mcap")->chunks();
  ASSERT_GE(chunks.size(), 4U);
  ASSERT_GT(chunks[1].length, missing + 2000);
  std::vector<Expected> left;
  for (const Expected& message : messages) {
    if (at(message.time) < chunks[1].start || chunks[1].end < at(message.time)) left.push_back(message);
  }
  writeBytes(folder_ / "broken.mcap",
             bytes.substr(0, chunks[1].offset + 1000) + bytes.substr(chunks[1].offset + 1000 + missing));
  const auto reader = test::open(folder_ / "broken.mcap");
  EXPECT_EQ(readAll(*reader), left);
  const auto report = repair(folder_ / "broken.mcap", folder_ / "repaired.mcap");
  ASSERT_TRUE(report);
  EXPECT_EQ(report->messages, left.size());
  EXPECT_EQ(report->chunksLost, 1U);
  EXPECT_LE(report->bytesLost, chunks[2].offset - chunks[1].offset);
}

INSTANTIATE_TEST_SUITE_P(Sizes, MissingPartTest,
                         testing::Combine(testing::Values(Compression::kNone, Compression::kLz4,
                                                          Compression::kZstd),
                                          testing::Values(1, 100, 4'000, 15'000, 20'000)));

class ZerosTest : public RepairTest, public testing::WithParamInterface<bool> {};

TEST_P(ZerosTest, atTheEndAreNotCountedAsLost) {
  const bool withinChunk = GetParam();
  writeBytes(broken_, bytes_.substr(0, chunks_[5].offset + (withinChunk ? 100 : 0)));
  std::filesystem::resize_file(broken_, std::filesystem::file_size(broken_) + (20U << 20U));
  const auto report = repair(broken_, repaired_);
  ASSERT_TRUE(report) << report.error().describe();
  EXPECT_EQ(report->chunksLost, withinChunk ? 1U : 0U);
  EXPECT_LE(report->bytesLost, withinChunk ? 100U : 0U);
  EXPECT_GE(report->bytesLost, withinChunk ? 90U : 0U);
  EXPECT_EQ(test::open(repaired_)->chunks().size(), 5U);
  const auto isOfZeros = [](const Damage& damage) {
    return damage.what.find("zero bytes") != std::string::npos;
  };
  EXPECT_EQ(std::ranges::count_if(report->damage, isOfZeros), 1);
}

INSTANTIATE_TEST_SUITE_P(Places, ZerosTest, testing::Bool());

TEST_F(RepairTest, zerosBehindACompleteFileCostNothing) {
  writeBytes(broken_, bytes_);
  std::filesystem::resize_file(broken_, bytes_.size() + (1U << 20U));
  const auto report = repair(broken_, repaired_);
  ASSERT_TRUE(report) << report.error().describe();
  EXPECT_EQ(report->messages, messages_.size());
  EXPECT_EQ(report->chunksLost, 0U);
  EXPECT_EQ(report->bytesLost, 0U);
}

}  // namespace
