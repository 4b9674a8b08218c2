// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/search/ConditionMatcher.h"

#include <gmock/gmock.h>

#include "foxglove/Robot.pb.h"
#include "robotcontrol/Debugging.pb.h"
#include "tests/logplayer/RecordedMessages.h"

namespace logplayer {
namespace {

using robotlink::StreamMessage;
using testing::ElementsAre;
using testing::IsEmpty;
using tests::at;

StreamMessage speedOf(const std::string& robot, int ms, double value) {
  return tests::plot(robot + "/plots/speed", ms, value);
}

StreamMessage logText(int ms, const std::string& text) {
  auto log = std::make_shared<foxglove::Log>();
  log->set_message(text);
  return {"red1/log", at(ms), log};
}

/// Matches an expression on the streams of red1 and red2, and notes the hits as "robot from-until" in ms.
class ConditionMatcherTest : public testing::Test {
 protected:
  void search(const std::string& expression) {
    auto bound = robotlink::BoundExpression::bind(
        expression, {"red1/plots/speed", "red2/plots/speed", "red1/plots/limit", "red1/log"},
        {"red1", "red2"});
    ASSERT_TRUE(bound) << bound.error().text;
    matcher_.add(std::move(*bound));
  }
  void take(const StreamMessage& message) {
    const auto taken = matcher_.take(message);
    ASSERT_TRUE(taken) << taken.error().text;
  }
  bool note(const SearchHit& hit) {
    const auto ms = [](robotlink::Instant time) {
      return std::to_string(time.time_since_epoch() / std::chrono::milliseconds(1));
    };
    hits_.push_back(hit.robot + " " + ms(hit.from) + "-" + (hit.until ? ms(*hit.until) : "end"));
    if (hit.text) texts_.push_back(dynamic_cast<const foxglove::Log&>(*hit.text->value).message());
    return hits_.size() < wanted_;
  }

  std::vector<std::string> hits_, texts_;
  std::size_t wanted_ = 100;
  ConditionMatcher matcher_{[this](const SearchHit& hit) { return note(hit); }};
};

TEST_F(ConditionMatcherTest, aHitLastsFromTheFirstValueThatFitsToTheFirstThatDoesNot) {
  search("red1/plots/speed.value > 2");
  const double speeds[] = {1, 3, 4, 3, 2, 1, 5, 0};
  for (int i = 0; i < 8; ++i) take(speedOf("red1", 10 * i, speeds[i]));
  EXPECT_THAT(hits_, ElementsAre(" 10-40")) << "whether the last value counts shows only what follows";
  matcher_.finish();
  EXPECT_THAT(hits_, ElementsAre(" 10-40", " 60-70"));
  EXPECT_EQ(matcher_.hits(), 2U);
}

TEST_F(ConditionMatcherTest, whatIsTrueAtTheEndHasNoEnd) {
  search("red1/plots/speed.value > 2");
  take(speedOf("red1", 0, 1));
  take(speedOf("red1", 10, 3));
  EXPECT_THAT(hits_, IsEmpty());
  matcher_.finish();
  EXPECT_THAT(hits_, ElementsAre(" 10-end"));
}

TEST_F(ConditionMatcherTest, messagesOfOneTimeCountTogetherInAnyOrder) {
  search("red1/plots/speed.value > red1/plots/limit.value");
  const auto limitOf = [](int ms, double value) { return tests::plot("red1/plots/limit", ms, value); };
  take(speedOf("red1", 0, 1));
  take(limitOf(0, 2));
  // The speed comes before its limit, and then behind it.
  take(speedOf("red1", 10, 3));
  take(limitOf(10, 4));
  take(limitOf(20, 1));
  take(speedOf("red1", 20, 0.5));
  matcher_.finish();
  EXPECT_THAT(hits_, IsEmpty());
}

TEST_F(ConditionMatcherTest, eachRobotHasHitsOfItsOwnInTheOrderOfTheirEnds) {
  search("plots/speed.value > 2");
  take(speedOf("red1", 0, 3));
  take(speedOf("red2", 10, 3));
  take(speedOf("red2", 20, 0));
  take(speedOf("red1", 30, 0));
  matcher_.finish();
  EXPECT_THAT(hits_, ElementsAre("red2 10-20", "red1 0-30"));
}

TEST_F(ConditionMatcherTest, aValueFromBeforeTheRangeCountsFromItsStart) {
  search("red1/plots/speed.value > 2");
  matcher_.beginAt(at(100));
  ASSERT_TRUE(matcher_.takeEarlier(speedOf("red1", 20, 3)));
  take(speedOf("red1", 150, 0));
  take(speedOf("red1", 160, 0));
  EXPECT_THAT(hits_, ElementsAre(" 100-150"));
}

TEST_F(ConditionMatcherTest, aValueFromBeforeTheRangeIsReplacedAtItsStart) {
  search("red1/plots/speed.value > 2");
  matcher_.beginAt(at(100));
  ASSERT_TRUE(matcher_.takeEarlier(speedOf("red1", 20, 3)));
  take(speedOf("red1", 100, 0));
  matcher_.finish();
  EXPECT_THAT(hits_, IsEmpty());
}

TEST_F(ConditionMatcherTest, textsAreHitsOneByOneEvenAtOneTime) {
  search("log.message =~ \"fall\"");
  ASSERT_TRUE(matcher_.takeEarlier(logText(0, "fallen before")));
  take(logText(10, "falling"));
  take(logText(10, "standing"));
  take(logText(10, "fallen"));
  take(speedOf("red1", 20, 1));
  matcher_.finish();
  EXPECT_THAT(hits_, ElementsAre("red1 10-10", "red1 10-10"));
  EXPECT_THAT(texts_, ElementsAre("falling", "fallen"));
}

TEST_F(ConditionMatcherTest, aTextIsOverWhenAnotherValueComes) {
  search("log.message == \"go\" && plots/speed.value > 2");
  take(logText(0, "go"));
  take(speedOf("red1", 10, 3));
  take(logText(20, "go"));
  matcher_.finish();
  EXPECT_THAT(hits_, ElementsAre("red1 20-20")) << "the first was said while there was no speed";
}

TEST_F(ConditionMatcherTest, itEndsWhenNoMoreIsWanted) {
  wanted_ = 1;
  search("plots/speed.value > 2");
  take(speedOf("red1", 0, 3));
  take(speedOf("red2", 0, 3));
  take(speedOf("red1", 10, 0));
  const auto ended = matcher_.take(speedOf("red2", 20, 0));
  ASSERT_FALSE(ended);
  EXPECT_EQ(ended.error().id, ConditionMatcher::kEnough);
  EXPECT_THAT(hits_, ElementsAre("red1 0-10"));
}

TEST_F(ConditionMatcherTest, noMoreThanWantedIsReportedAtTheEnd) {
  wanted_ = 1;
  search("plots/speed.value > 2");
  take(speedOf("red1", 0, 3));
  take(speedOf("red2", 0, 3));
  matcher_.finish();
  EXPECT_THAT(hits_, ElementsAre("red1 0-end"));
  EXPECT_EQ(matcher_.hits(), 1U);
}

TEST_F(ConditionMatcherTest, aMessageOfAnotherTypeFailsWithTheNameOfItsField) {
  search("red1/plots/speed.value > 2");
  auto keys = std::make_shared<robotcontrol::KeyTable>();
  const auto taken = matcher_.take({"red1/plots/speed", at(0), keys});
  ASSERT_FALSE(taken);
  EXPECT_THAT(taken.error().text, testing::HasSubstr("value"));
  EXPECT_FALSE(matcher_.takeEarlier({"red1/plots/speed", at(0), keys}));
}

TEST_F(ConditionMatcherTest, streamsOfAllExpressionsAreNeeded) {
  search("plots/speed.value > 2");
  search("red1/plots/limit.value > 2 && red1/plots/speed.value > 1");
  EXPECT_THAT(matcher_.streams(), ElementsAre("red1/plots/limit", "red1/plots/speed", "red2/plots/speed"));
}

TEST_F(ConditionMatcherTest, aValueThatNoMessageHadIsNamedOnce) {
  search("plots/speed.value > 2");
  search("red2/plots/speed.value > 3");
  take(speedOf("red1", 0, 3));
  EXPECT_THAT(matcher_.neverFound(),
              ElementsAre("no message has red2/plots/speed.value, so that the expression has no value"));
  take(speedOf("red2", 0, 1));
  EXPECT_THAT(matcher_.neverFound(), IsEmpty());
}

}  // namespace
}  // namespace logplayer
