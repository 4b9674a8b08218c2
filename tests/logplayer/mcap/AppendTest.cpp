// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "logplayer/mcap/RecordBytes.h"
#include "tests/logplayer/mcap/TemporaryLog.h"

using namespace logplayer::mcap;
using namespace logplayer::mcap::test;
using testing::IsEmpty;

namespace {

class AppendTest : public testing::Test {
 protected:
  void SetUp() override { writeLog(log_, messages_); }
  std::unique_ptr<Writer> append() {
    auto writer = Writer::append(log_, {});
    EXPECT_TRUE(writer) << writer.error().describe();
    return std::move(*writer);
  }

  TemporaryFolder folder_;
  std::filesystem::path log_ = folder_ / "log.mcap";
  std::vector<Expected> messages_ = someMessages(20);
};

TEST_F(AppendTest, whatIsAppendedComesBehindWhatWasThere) {
  const auto writer = append();
  EXPECT_EQ(writer->addSchema("s", "protobuf", "described by this").value(), 1);
  EXPECT_EQ(writer->addChannel("c2", 1, "protobuf", {{"process", "p"}}).value(), 2);
  EXPECT_EQ(writer->addChannel("new", 1, "protobuf", {}).value(), 4);
  messages_.push_back({2, 7, 1000, "more"});
  messages_.push_back({4, 8, 2000, "new"});
  write(*writer, messages_[20]);
  write(*writer, messages_[21]);
  ASSERT_TRUE(writer->addMetadata({"m", {{"a", "b"}}}));
  ASSERT_TRUE(writer->close());

  const auto reader = test::open(log_);
  EXPECT_TRUE(reader->complete());
  EXPECT_EQ(readForwards(*reader, {1, 2, 3, 4}), messages_);
  EXPECT_EQ(reader->statistics().messageCount, 22U);
  EXPECT_EQ(reader->statistics().messageEnd, at(2000));
  EXPECT_EQ(reader->metadata().size(), 1U);
  EXPECT_TRUE(reader->verify());
  EXPECT_THAT(reader->damage(), IsEmpty());
}

TEST_F(AppendTest, aFileToWhichNothingIsAppendedIsNotTouched) {
  const std::string before = readBytes(log_);
  const auto modified = std::filesystem::last_write_time(log_);
  ASSERT_TRUE(append()->close());
  EXPECT_EQ(readBytes(log_), before);
  EXPECT_EQ(std::filesystem::last_write_time(log_), modified);
}

TEST_F(AppendTest, whoeverIsKilledWhileAppendingLeavesWhatWasThere) {
  const auto writer = append();
  write(*writer, {1, 0, 1000, "lost"});
  ASSERT_TRUE(writer->flush());
  writeBytes(folder_ / "killed.mcap", readBytes(log_));
  const auto reader = test::open(folder_ / "killed.mcap");
  EXPECT_FALSE(reader->complete());
  messages_.push_back({1, 0, 1000, "lost"});
  EXPECT_EQ(readForwards(*reader), messages_);
}

TEST_F(AppendTest, anIncompleteFileIsRefused) {
  writeBytes(log_, readBytes(log_).substr(0, 500));
  const auto writer = Writer::append(log_, {});
  ASSERT_FALSE(writer);
  EXPECT_EQ(writer.error().id, "mcap.incomplete");
  EXPECT_EQ(std::filesystem::file_size(log_), 500U);
}

}  // namespace
