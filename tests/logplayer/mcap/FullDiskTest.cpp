// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <sys/mount.h>
#include <sys/resource.h>

#include <csignal>

#include "logplayer/mcap/RecordBytes.h"
#include "tests/logplayer/mcap/TemporaryLog.h"

// The disk fills up in the middle of a recording: by a limit on the size of files, and, where the right is
// there, by a small file system in memory.
using namespace logplayer::mcap;
using namespace logplayer::mcap::test;
using testing::HasSubstr;

namespace {

class FullDiskTest : public testing::TestWithParam<const char*> {
 protected:
  static constexpr std::size_t kDiskBytes = 256U << 10U;

  void SetUp() override {
    std::filesystem::create_directories(disk_);
    if (std::string(GetParam()) == "limit") {
      previous_ = std::signal(SIGXFSZ, SIG_IGN);
      ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &limit_), 0);
      rlimit small = limit_;
      small.rlim_cur = kDiskBytes;
      ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    } else {
      const std::string size = "size=" + std::to_string(kDiskBytes);
      mounted_ = ::mount("tmpfs", disk_.c_str(), "tmpfs", 0, size.c_str()) == 0;
      if (!mounted_) GTEST_SKIP() << "a file system cannot be mounted by this user";
    }
  }
  void TearDown() override {
    if (mounted_) ::umount(disk_.c_str());
    if (limit_.rlim_max == 0) return;
    ::setrlimit(RLIMIT_FSIZE, &limit_);
    std::signal(SIGXFSZ, previous_);
  }

  /// Writes until it fails; yields how often it did not.
  std::size_t fill(Writer& writer, const std::vector<Expected>& messages) {
    for (std::size_t i = 0; i < messages.size(); ++i) {
      const Expected& expected = messages[i];
      const auto written = writer.write({expected.channelId, expected.sequence, at(expected.time),
                                         at(expected.time + 1), bytesOf(expected.data)});
      if (!written) return i;
    }
    return messages.size();
  }

  TemporaryFolder folder_;
  std::filesystem::path disk_ = folder_ / "disk";
  bool mounted_ = false;
  rlimit limit_{};
  void (*previous_)(int) = SIG_DFL;
};

TEST_P(FullDiskTest, theErrorIsReportedAndTheFileIsComplete) {
  const std::vector<Expected> messages = someMessages(1000, 1000);
  Writer::Options options;
  options.chunkBytes = 20'000;
  auto writer = Writer::create(disk_ / "log.mcap", options);
  ASSERT_TRUE(writer);
  addChannels(**writer, 3);
  const std::size_t written = fill(**writer, messages);
  ASSERT_LT(written, messages.size());
  const auto ticked = (*writer)->tick();
  ASSERT_FALSE(ticked);
  EXPECT_THAT(ticked.error().describe(), HasSubstr("cannot write the log file"));
  EXPECT_FALSE((*writer)->flush());
  EXPECT_FALSE((*writer)->addMetadata({"m", {}}));
  EXPECT_FALSE((*writer)->close());
  EXPECT_EQ(fill(**writer, messages), 0U);
  const std::uint64_t counted = (*writer)->statistics().messageCount;
  writer->reset();

  // What did not fit made room for the summary.
  const auto reader = test::open(disk_ / "log.mcap");
  ASSERT_NE(reader, nullptr);
  EXPECT_TRUE(reader->complete());
  EXPECT_TRUE(reader->verify());
  EXPECT_TRUE(reader->damage().empty());
  const std::vector<Expected> read = readAll(*reader);
  EXPECT_EQ(read.size(), counted);
  EXPECT_GT(read.size(), written - 25);
  EXPECT_EQ(read, std::vector<Expected>(messages.begin(),
                                        messages.begin() + static_cast<std::ptrdiff_t>(read.size())));
}

TEST_P(FullDiskTest, aRepairThatDoesNotFitLeavesNothing) {
  if (mounted_) {
    writeLog(folder_ / "whole.mcap", someMessages(400, 1000));
  } else {
    ::setrlimit(RLIMIT_FSIZE, &limit_);
    writeLog(folder_ / "whole.mcap", someMessages(400, 1000));
    rlimit small = limit_;
    small.rlim_cur = kDiskBytes;
    ::setrlimit(RLIMIT_FSIZE, &small);
  }
  const auto report = repair(folder_ / "whole.mcap", disk_ / "repaired.mcap");
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().id, "mcap.write");
  EXPECT_FALSE(std::filesystem::exists(disk_ / "repaired.mcap"));
}

INSTANTIATE_TEST_SUITE_P(Ways, FullDiskTest, testing::Values("limit", "tmpfs"),
                         [](const auto& way) { return std::string(way.param); });

}  // namespace
