// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/LogInfo.h"

#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "logplayer/bookmarks/BookmarkStorage.h"
#include "tests/game/Data.h"
#include "tests/game/Log.h"
#include "tests/logplayer/SampleLog.h"

namespace logplayer {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;

class LogInfoTest : public testing::Test {
 protected:
  LogInfo info(const SampleLog& sample = {}) {
    sample.write(folder_ / "a.mcap");
    const auto read = readLogInfo(folder_ / "a.mcap");
    EXPECT_TRUE(read) << read.error().describe();
    return read.value_or(LogInfo{});
  }
  TestFolder folder_;
};

TEST_F(LogInfoTest, countsWhatALogHolds) {
  const LogInfo found = info();
  EXPECT_EQ(found.format, "MCAP");
  EXPECT_EQ(found.messages, 1U + 2 + 2 * 100 + 3 * 100 + 10);
  EXPECT_EQ(found.frames, 100U);
  EXPECT_THAT(found.framesOf, ElementsAre(Pair("red1/cognition", 100U), Pair("red1/platform", 100U)));
  EXPECT_EQ(found.images, 100U);
  EXPECT_THAT(found.robots, ElementsAre("red1"));
  EXPECT_EQ(found.begin, sampleTime(0));
  EXPECT_EQ(found.end, sampleTime(99));
  EXPECT_TRUE(found.complete);
  EXPECT_THAT(found.losses, IsEmpty());
  EXPECT_EQ(found.fileBytes, std::filesystem::file_size(folder_ / "a.mcap"));
  ASSERT_EQ(found.streams.size(), 8U);
  const auto& image = found.streams[0];
  EXPECT_EQ(image.path, "red1/camera/image");
  EXPECT_EQ(image.type, "foxglove.RawImage");
  EXPECT_EQ(image.count, 100U);
  EXPECT_NEAR(image.rate, 25, 1e-9);
  EXPECT_GT(image.bytes, 100U * 8);
}

TEST_F(LogInfoTest, jsonHasTheNamesThatScriptsLookFor) {
  const auto object = toJson(info());
  EXPECT_EQ(object.at("frames"), 100);
  EXPECT_EQ(object.at("images"), 100);
  EXPECT_NEAR(object.at("duration_s").get<double>(), 99 * 0.04, 1e-9);
  EXPECT_EQ(object.at("messages"), 513);
  const auto& stream = object.at("streams").at(0);
  for (const char* name : {"path", "type", "count", "bytes", "rate_hz"})
    EXPECT_TRUE(stream.contains(name)) << name;
}

TEST_F(LogInfoTest, columnsAreAlignedAndHaveUnits) {
  ASSERT_TRUE(writeBookmarksBeside(folder_ / "a.mcap",
                                   {{1, Bookmark{1, sampleTime(50), sampleTime(50), "ball missed"}}}));
  const std::string text = toText(info());
  EXPECT_THAT(text, HasSubstr("  time      0.000 s to 3.960 s, 3.960 s long\n"));
  EXPECT_THAT(text, HasSubstr("   2.000 s      ball missed\n"));
  EXPECT_THAT(text, HasSubstr("  red1/camera/image      foxglove.RawImage            100  25.0 Hz"));
}

TEST_F(LogInfoTest, whatIsWrongIsListed) {
  const LogInfo found = info({.close = false, .cutLastFrame = true});
  EXPECT_FALSE(found.complete);
  EXPECT_THAT(found.losses, ElementsAre(HasSubstr("not closed")));
  EXPECT_EQ(found.frames, 99U);
  EXPECT_EQ(found.images, 99U) << "what the last frame lacks is not counted";
}

TEST_F(LogInfoTest, whatCannotBeReadIsAnError) {
  EXPECT_FALSE(readLogInfo(folder_ / "none.mcap"));
}

TEST_F(LogInfoTest, itIsGivenUpByProgress) {
  SampleLog{.frames = 1000}.write(folder_ / "a.mcap");
  const auto read = readLogInfo(folder_ / "a.mcap", [](double) { return false; });
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().id, "log.given-up");
}

/// Bytes that this program has read from files so far.
std::uint64_t bytesRead() {
  std::ifstream file("/proc/self/io");
  std::string name;
  std::uint64_t bytes = 0;
  file >> name >> bytes;
  return bytes;
}

TEST_F(LogInfoTest, aFileThatWasNotClosedIsLookedThroughOnce) {
  const auto file = folder_ / "a.mcap";
  SampleLog sample;
  sample.close = false;
  sample.write(file);
  const std::uint64_t tail = 16U << 20U;
  std::filesystem::resize_file(file, std::filesystem::file_size(file) + tail);
  const std::uint64_t before = bytesRead();
  const auto read = readLogInfo(file);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->messages, 513U);
  EXPECT_LT(bytesRead() - before, tail + tail / 2);
}

/// The parameter is the source of a whole log.
class WholeLogInfo : public testing::TestWithParam<std::string> {};

TEST_P(WholeLogInfo, aLogOf2009IsDescribed) {
  const bool real = GetParam() == "real";
  const auto log = game::dataOf(GetParam()) / "logs/bhuman2009.log";
  if (!std::filesystem::exists(log)) GTEST_SKIP() << "the real log is not at " << log;
  const auto found = readLogInfo(log);
  ASSERT_TRUE(found) << found.error().describe();
  EXPECT_EQ(found->images, real ? 160U : game::View::kCount);
  EXPECT_EQ(found->frames, real ? 434U : game::Log::kFrames);
  EXPECT_NEAR(robotlink::seconds(found->begin), real ? 486.749 : 20, 1);
}

INSTANTIATE_TEST_SUITE_P(Logs, WholeLogInfo, testing::ValuesIn(game::kSources),
                         [](const auto& source) { return source.param; });

}  // namespace
}  // namespace logplayer
