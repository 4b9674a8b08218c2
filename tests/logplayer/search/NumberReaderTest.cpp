// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/search/NumberReader.h"

#include <gmock/gmock.h>

#include "tests/Eventually.h"
#include "tests/logplayer/SampleLog.h"

namespace logplayer {
namespace {

using testing::HasSubstr;

const LogNumber kBall{"red1/models/ball", "position_in_robot.x"};
const LogNumber kJoint{"red1/joints/states", "joints[head_pan].position"};

class NumberReaderTest : public testing::Test {
 protected:
  void SetUp() override { SampleLog{.frames = kFrames}.write(folder_ / "a.mcap"); }
  /// Takes what is read until all of it is complete.
  void readAll(NumberReader& reader, std::size_t numbers) {
    ASSERT_TRUE(eventually([&] {
      const auto news = reader.take();
      for (const auto& [number, points] : news.points)
        all_[number].insert(all_[number].end(), points.begin(), points.end());
      return news.complete.size() == numbers;
    }));
  }
  /// Checks that each frame is there once, in order.
  void checkFrames(const LogNumber& number, double perFrame) {
    const auto& points = all_[number];
    ASSERT_EQ(points.size(), std::size_t{kFrames});
    for (std::size_t i = 0; i < points.size(); ++i) {
      ASSERT_EQ(points[i].time, robotlink::seconds(sampleTime(static_cast<int>(i))));
      ASSERT_EQ(points[i].value, perFrame * static_cast<double>(i));
    }
  }

  static constexpr int kFrames = 5000;
  TestFolder folder_;
  std::map<LogNumber, NumberReader::Points> all_;
};

TEST_F(NumberReaderTest, readsNumbersOfAWholeLog) {
  NumberReader reader(folder_ / "a.mcap");
  reader.read({kBall, kJoint});
  readAll(reader, 2);
  checkFrames(kBall, 1);
  checkFrames(kJoint, 0.5);
  EXPECT_EQ(reader.take().progress, 1);
}

TEST_F(NumberReaderTest, anExpressionHasAPointWheneverOneOfItsStreamsHasAMessage) {
  const LogNumber twice{
      "", "2 * red1/models/ball.position_in_robot.x + 0 * red1/joints/states.joints[head_pan].position"};
  NumberReader reader(folder_ / "a.mcap");
  reader.read({kBall});
  reader.read({kBall, twice});
  ASSERT_NO_FATAL_FAILURE(readAll(reader, 2));
  const auto& points = all_[twice];
  ASSERT_GE(points.size(), std::size_t{kFrames});
  for (std::size_t i = 1; i < points.size(); ++i) {
    ASSERT_GT(points[i].time, points[i - 1].time);
    ASSERT_GE(points[i].value, points[i - 1].value);
  }
  EXPECT_EQ(points.back().value, 2.0 * (kFrames - 1));
}

TEST_F(NumberReaderTest, textsAreNumbersWithNamesAndWhatDoesNotFitSaysWhy) {
  const LogNumber text{"red1/log", "message"}, wrong{"", "red1/models/bal.position_in_robot.x"};
  NumberReader reader(folder_ / "a.mcap");
  reader.read({text, wrong});
  NumberReader::Texts texts;
  std::string problem;
  NumberReader::Points points;
  ASSERT_TRUE(eventually([&] {
    auto news = reader.take();
    texts.merge(news.texts[text]);
    points.insert(points.end(), news.points[text].begin(), news.points[text].end());
    if (news.problems.contains(wrong)) problem = news.problems.at(wrong).text;
    return news.complete.size() == 2;
  }));
  ASSERT_EQ(points.size(), std::size_t{kFrames / 10});
  EXPECT_EQ(texts.at(points[3].value), "frame 30, \"quoted\"");
  EXPECT_THAT(problem, HasSubstr("models/ball"));
}

TEST_F(NumberReaderTest, whatIsWantedLaterCatchesUpAndNothingIsReadTwice) {
  NumberReader reader(folder_ / "a.mcap");
  reader.read({kBall});
  ASSERT_TRUE(eventually([&] {
    auto news = reader.take();
    auto& points = all_[kBall];
    points.insert(points.end(), news.points[kBall].begin(), news.points[kBall].end());
    return !points.empty();
  }));
  reader.read({kBall, kJoint});
  readAll(reader, 2);
  checkFrames(kBall, 1);
  checkFrames(kJoint, 0.5);
}

TEST_F(NumberReaderTest, whatIsNotWantedAnyMoreIsNotReadAndBeginsAnewLater) {
  NumberReader reader(folder_ / "a.mcap");
  reader.read({kBall, kJoint});
  reader.read({kJoint});
  EXPECT_FALSE(reader.take().points.contains(kBall));
  readAll(reader, 1);
  EXPECT_FALSE(all_.contains(kBall));
  reader.read({kBall, kJoint});
  readAll(reader, 2);
  checkFrames(kBall, 1);
  checkFrames(kJoint, 0.5);
}

TEST_F(NumberReaderTest, fewPointsWaitHoweverLongTheLogIs) {
  constexpr std::size_t kFew = 10;
  {
    NumberReader reader(folder_ / "a.mcap", kFew);
    reader.read({kBall});  // ends while its points wait
  }
  NumberReader reader(folder_ / "a.mcap", kFew);
  reader.read({kBall});
  ASSERT_TRUE(eventually([&] {
    auto news = reader.take();
    auto& points = news.points[kBall];
    EXPECT_LE(points.size(), kFew + NumberReader::kInstants);
    all_[kBall].insert(all_[kBall].end(), points.begin(), points.end());
    return !news.complete.empty();
  }));
  checkFrames(kBall, 1);
}

TEST_F(NumberReaderTest, aNumberThatNoMessageHasIsCompleteWithoutPoints) {
  NumberReader reader(folder_ / "a.mcap");
  reader.read({{kBall.stream, "no.such"}, {"no/stream", "x"}, {kBall.stream, "]["}});
  readAll(reader, 3);
  EXPECT_TRUE(all_.empty());
}

TEST_F(NumberReaderTest, aFileThatIsNoLogIsReported) {
  NumberReader reader(folder_ / "none.mcap");
  reader.read({kBall});
  std::optional<robotlink::Error> failure;
  ASSERT_TRUE(eventually([&] { return (failure = reader.take().failure).has_value(); }));
  EXPECT_THAT(failure->describe(), HasSubstr("none.mcap"));
}

}  // namespace
}  // namespace logplayer
