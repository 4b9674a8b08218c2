// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/mcap/read/KnownIndexes.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/stat.h>

#include "tests/logplayer/mcap/TemporaryLog.h"

using namespace logplayer::mcap;
using namespace logplayer::mcap::test;
using testing::SizeIs;

namespace {

/// A log whose writer was killed: it can only be looked through.
class KnownIndexesTest : public testing::Test {
 protected:
  void SetUp() override {
    std::vector<std::size_t> flushes;
    for (std::size_t i = 10; i < messages_.size(); i += 10) flushes.push_back(i);
    writeLog(file_, messages_, {}, flushes);
    chunks_ = test::open(file_)->chunks();
    writeBytes(file_, readBytes(file_).substr(0, chunks_.back().offset + 20));
  }
  /// Makes a chunk unrecognizable, which nobody sees by the file's size and time.
  void spoilSecretly(const Reader::ChunkInfo& chunk) {
    struct stat before {};
    ASSERT_EQ(::stat(file_.c_str(), &before), 0);
    const int descriptor = ::open(file_.c_str(), O_WRONLY);
    const std::uint8_t bytes[] = {0xFF, 0xFF, 0xFF, 0xFF};
    ASSERT_EQ(::pwrite(descriptor, bytes, sizeof bytes, static_cast<off_t>(chunk.offset)), 4);
    const timespec times[] = {before.st_atim, before.st_mtim};
    ASSERT_EQ(::futimens(descriptor, times), 0);
    ::close(descriptor);
  }

  TemporaryFolder folder_;
  std::filesystem::path file_ = folder_ / "log.mcap";
  std::vector<Expected> messages_ = someMessages(50);
  std::vector<Reader::ChunkInfo> chunks_;
};

TEST_F(KnownIndexesTest, aFileThatIsOpenIsNotLookedThroughAgain) {
  auto first = test::open(file_);
  ASSERT_THAT(first->chunks(), SizeIs(4));
  spoilSecretly(chunks_[1]);
  EXPECT_THAT(test::open(file_)->chunks(), SizeIs(4));
  first.reset();
  EXPECT_THAT(test::open(file_)->chunks(), SizeIs(3)) << "what nobody uses is forgotten";
}

TEST_F(KnownIndexesTest, aFileThatWasChangedIsLookedThroughAgain) {
  const auto first = test::open(file_);
  ASSERT_THAT(first->chunks(), SizeIs(4));
  writeBytes(file_, readBytes(file_).substr(0, chunks_[2].offset));
  EXPECT_THAT(test::open(file_)->chunks(), SizeIs(2));
}

TEST_F(KnownIndexesTest, whatOneReaderFindsToBeDamagedIsNotKnownToOthers) {
  spoilSecretly(chunks_[1]);
  const auto first = test::open(file_);
  const std::size_t damage = first->damage().size();
  EXPECT_EQ(readAll(*first).size(), 30U);
  const auto second = test::open(file_);
  EXPECT_THAT(second->damage(), SizeIs(damage));
  EXPECT_EQ(readByCursor(*second).size(), 30U);
}

}  // namespace
