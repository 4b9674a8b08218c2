// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "logplayer/mcap/ByteStream.h"
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
    for (const Told& message : messages_) write(**writer, message);
    ASSERT_TRUE((*writer)->attach({at(1), at(2), "notes", "text/plain", "some"}));
    ASSERT_TRUE((*writer)->addMetadata({"m", {{"a", "b"}}}));
    ASSERT_TRUE((*writer)->close());
    bytes_ = readBytes(whole_);
    chunks_ = test::open(whole_)->chunks();
  }
  /// All messages but those in some chunk, given its number.
  std::vector<Told> without(std::size_t chunk) const {
    std::vector<Told> left;
    for (const Told& message : messages_) {
      const Instant time = at(message.time);
      if (time < chunks_[chunk].start || time > chunks_[chunk].end) left.push_back(message);
    }
    return left;
  }

  TemporaryFolder folder_;
  std::filesystem::path whole_ = folder_ / "whole.mcap";
  std::filesystem::path broken_ = folder_ / "broken.mcap";
  std::filesystem::path repaired_ = folder_ / "repaired.mcap";
  std::vector<Told> messages_ = someMessages(200);
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

TEST_F(VerifyTest, aWrongMessageIndexIsToldAndDoneWithout) {
  // The offset in the first entry of the message index behind the third chunk.
  bytes_[chunks_[2].offset + chunks_[2].length + 9 + 2 + 4 + 8] ^= 0x04;
  writeBytes(broken_, bytes_);
  const auto reader = test::open(broken_);
  EXPECT_TRUE(reader->verify());
  ASSERT_THAT(reader->damage(), SizeIs(1));
  EXPECT_THAT(reader->damage()[0].what, HasSubstr("message indexes"));
  EXPECT_EQ(readForwards(*reader), messages_);
}

}  // namespace
