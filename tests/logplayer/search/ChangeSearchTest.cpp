// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/search/ChangeSearch.h"

#include <gmock/gmock.h>

#include "tests/logplayer/SampleLog.h"

namespace logplayer {
namespace {

using robotlink::Instant;
using testing::HasSubstr;

constexpr char kSampleBall[] = "models/ball.position_in_robot.x";

class ChangeSearchTest : public testing::Test {
 protected:
  void SetUp() override {
    SampleLog{.frames = 500}.write(folder_ / "a.mcap");
    auto log = LogFile::open(folder_ / "a.mcap", {});
    ASSERT_TRUE(log);
    log_ = *log;
  }
  /// Number of the frame to which a step leads; -1: to none.
  int frameOf(const std::string& expression, int from, bool isForward, std::optional<double> limit = {}) {
    const auto found = findChange(log_, {expression, "red1", limit, sampleTime(from), isForward});
    if (!found) ADD_FAILURE() << found.error().text;
    if (!found || !*found) return -1;
    return static_cast<int>((**found - sampleTime(0)) / std::chrono::milliseconds(40));
  }

  TestFolder folder_;
  std::shared_ptr<LogFile> log_;
};

TEST_F(ChangeSearchTest, eachOtherValueIsAChange) {
  EXPECT_EQ(frameOf(kSampleBall, 100, true), 101);
  EXPECT_EQ(frameOf(kSampleBall, 100, false), 99);
  EXPECT_EQ(frameOf(kSampleBall, 499, true), -1);
  EXPECT_EQ(frameOf(kSampleBall, 0, false), -1);
}

TEST_F(ChangeSearchTest, aLimitIsReachedOrLeftFarAwayInBothDirections) {
  EXPECT_EQ(frameOf(kSampleBall, 3, true, 400), 400);
  EXPECT_EQ(frameOf(kSampleBall, 400, true, 400), -1);
  EXPECT_EQ(frameOf(kSampleBall, 499, false, 20), 20);
  EXPECT_EQ(frameOf(kSampleBall, 20, false, 20), 0) << "the value appears";
  EXPECT_EQ(frameOf(kSampleBall, 499, false, 1000), 0);
}

TEST_F(ChangeSearchTest, expressionsAndTextsChange) {
  EXPECT_EQ(
      frameOf("red1/models/ball.position_in_robot.x > 250 && red1/models/ball.position_in_robot.x < 300", 10,
              true),
      251);
  EXPECT_EQ(frameOf("models/ball.position_in_robot.x > 250", 499, false), 251);
  EXPECT_EQ(frameOf("log.message", 1, true), 10);
  EXPECT_EQ(frameOf("log.message", 25, false), 20);
}

TEST_F(ChangeSearchTest, whatDoesNotFitFailsAndACanceledSearchSaysSo) {
  const auto wrong = [&](const std::string& expression) {
    const auto found = findChange(log_, {expression, "red1", {}, sampleTime(0), true});
    return found ? std::string("found") : found.error().text;
  };
  EXPECT_THAT(wrong("models/bal.position_in_robot.x"), HasSubstr("models/ball"));
  EXPECT_THAT(wrong("models/ball.position_in_robo.x"), HasSubstr("position_in_robot"));
  EXPECT_THAT(wrong("1 + 1"), HasSubstr("no stream"));
  const auto canceled = findChange(
      log_,
      {"models/ball.position_in_robot.x > 1000 || log.message == \"\"", "red1", {}, sampleTime(0), true},
      [](double) { return false; });
  EXPECT_TRUE(canceled || canceled.error().id == "log.given-up");
}

}  // namespace
}  // namespace logplayer
