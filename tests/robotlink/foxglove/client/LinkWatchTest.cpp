// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/client/LinkWatch.h"

#include <gmock/gmock.h>

namespace robotlink::websocket {
namespace {

using namespace std::chrono_literals;
using Action = LinkWatch::Action;
using Failure = LinkWatch::Failure;
using Phase = ConnectionState::Phase;

class LinkWatchTest : public testing::Test {
 protected:
  /// What it wants to do within this time, looked at every 10 ms, with its times in ms. Addresses are known.
  std::vector<std::pair<Action, int>> actions(Duration time) {
    std::vector<std::pair<Action, int>> found;
    for (const Instant end = now_ + time; now_ < end; now_ += 10ms) {
      const Action action = watch_.next(now_);
      if (action == Action::kConnect) watch_.addressFound(now_);
      if (action != Action::kNone)
        found.emplace_back(action, static_cast<int>(now_.time_since_epoch() / 1ms));
    }
    return found;
  }
  void connect() {
    while (watch_.next(now_) != Action::kConnect) now_ += 10ms;
    watch_.stepDone(now_);
    watch_.stepDone(now_);
    watch_.greeted(now_);
  }

  Instant now_;
  LinkWatch watch_{{}, now_};
};

TEST_F(LinkWatchTest, whatDoesNotAnswerIsTriedAgainWithPausesOfLessThanASecond) {
  EXPECT_EQ(actions(4500ms), (std::vector<std::pair<Action, int>>{{Action::kConnect, 0},
                                                                  {Action::kGiveUp, 1000},
                                                                  {Action::kConnect, 1200},
                                                                  {Action::kGiveUp, 2200},
                                                                  {Action::kConnect, 2400},
                                                                  {Action::kGiveUp, 3400},
                                                                  {Action::kConnect, 3600}}));
  EXPECT_EQ(watch_.phase(), Phase::kConnecting);
  EXPECT_THAT(watch_.reason(), testing::HasSubstr("nothing answers"));
}

TEST_F(LinkWatchTest, aNameThatIsLookedUpForLongIsWaitedForAndSaid) {
  EXPECT_EQ(watch_.next(now_), Action::kConnect);
  for (const Instant end = now_ + 25s; now_ < end; now_ += 10ms) EXPECT_EQ(watch_.next(now_), Action::kNone);
  EXPECT_EQ(watch_.phase(), Phase::kConnecting);
  EXPECT_THAT(watch_.reason(), testing::HasSubstr("the name of the robot"));
  // TCP has its own time, from then on.
  watch_.addressFound(now_);
  EXPECT_EQ(actions(1010ms).size(), 1U);
  EXPECT_THAT(watch_.reason(), testing::HasSubstr("nothing answers"));
}

TEST_F(LinkWatchTest, aNameThatIsNeverFoundIsGivenUpAndTriedAgain) {
  EXPECT_EQ(watch_.next(now_), Action::kConnect);
  now_ += 30s;
  EXPECT_EQ(watch_.next(now_), Action::kGiveUp);
  EXPECT_THAT(watch_.reason(), testing::HasSubstr("check the name, or use the IP address"));
  EXPECT_EQ(actions(210ms).size(), 1U);
}

TEST_F(LinkWatchTest, aSignOfLifeIsAskedForAndSilenceEndsTheConnection) {
  connect();
  EXPECT_EQ(watch_.phase(), Phase::kConnected);
  EXPECT_EQ(actions(1000ms).size(), 3U);
  watch_.heard(now_);
  actions(1010ms);
  EXPECT_EQ(watch_.phase(), Phase::kSilent);
  EXPECT_EQ(watch_.since(), Instant(1s));
  watch_.heard(now_);
  actions(10ms);
  EXPECT_EQ(watch_.phase(), Phase::kConnected);
  const auto after = actions(3s);
  EXPECT_EQ(after.back().first, Action::kGiveUp);
  EXPECT_EQ(watch_.phase(), Phase::kSilent);
  // It stays silent while it is not reached.
  actions(10s);
  EXPECT_EQ(watch_.phase(), Phase::kSilent);
  EXPECT_EQ(watch_.since(), Instant(2010ms));
}

TEST_F(LinkWatchTest, itAsksForASignOfLifeOnlyInSilenceAndNowAndThenForTheRoundTrip) {
  connect();
  int asked = 0, given = 0;
  for (const Instant end = now_ + 10s; now_ < end; now_ += 10ms) {
    watch_.heard(now_);
    const Action action = watch_.next(now_);
    asked += action == Action::kPing ? 1 : 0;
    given += action == Action::kPong ? 1 : 0;
  }
  EXPECT_EQ(asked + given, 33);
  EXPECT_LE(asked, 6);
  EXPECT_EQ(watch_.phase(), Phase::kConnected);
}

TEST_F(LinkWatchTest, afterTheFirstSuccessItIsBackWithinTwoSecondsOfTheLinesReturn) {
  connect();
  actions(20s);
  // Whenever the line returns, the next try begins in time.
  for (int i = 0; i < 300; ++i) {
    now_ += 10ms;
    if (watch_.next(now_) == Action::kConnect) {
      watch_.addressFound(now_);
      if (i % 2 == 0) watch_.stepDone(now_);
    }
    Instant back = now_;
    LinkWatch copy = watch_;
    while (copy.next(back) != Action::kConnect) back += 10ms;
    EXPECT_LE(back - now_, 1200ms);
  }
}

TEST_F(LinkWatchTest, aRefusalIsRepeatedSlowlyAndShown) {
  EXPECT_EQ(actions(10ms).size(), 1U);
  watch_.failed(Failure::kRefused, "another token", now_);
  EXPECT_EQ(watch_.phase(), Phase::kRefused);
  EXPECT_TRUE(actions(5s).empty());
  EXPECT_EQ(actions(10ms).size(), 1U);
  EXPECT_EQ(watch_.phase(), Phase::kRefused);
  EXPECT_EQ(watch_.reason(), "another token");
  watch_.failed(Failure::kEnded, "nobody listens", now_);
  EXPECT_EQ(watch_.phase(), Phase::kConnecting);
}

TEST_F(LinkWatchTest, aServerThatEndsTheConnectionIsNotSilent) {
  connect();
  watch_.failed(Failure::kEnded, "the program ended", now_);
  EXPECT_EQ(watch_.phase(), Phase::kConnecting);
  EXPECT_EQ(watch_.reason(), "the program ended");
}

}  // namespace
}  // namespace robotlink::websocket
