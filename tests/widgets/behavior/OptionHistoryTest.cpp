// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/behavior/OptionHistory.h"

#include <gtest/gtest.h>

#include "robotcontrol/Motion.pb.h"
#include "tests/widgets/streams/StoredMessages.h"

namespace widgets::test {
namespace {

/// What a behavior reports that is in one state of one option.
robotcontrol::BehaviorState inState(const char* state, const char* reason = "") {
  robotcontrol::BehaviorState message;
  auto& active = *message.add_active();
  active.set_option("game");
  active.set_state(state);
  active.set_reason(reason);
  return message;
}

class OptionHistoryTest : public testing::Test {
 protected:
  void add(double time, const char* state) { stored.add("red1/behavior", time, inState(state)); }
  void read(double until) { history.read(stored.store.find("red1/behavior"), atSeconds(until)); }
  /// "play 1-3, rest 3-4", of the first option.
  std::string segments() const {
    QStringList all;
    if (history.rows().empty()) return "nothing";
    for (const auto& segment : history.rows()[0].segments)
      all << QStringLiteral("%1 %2-%3").arg(segment.state).arg(segment.from).arg(segment.to);
    return all.join(QStringLiteral(", ")).toStdString();
  }

  StoredMessages stored;
  OptionHistory history;
};

TEST_F(OptionHistoryTest, whatIsNewIsAddedToWhatWasRead) {
  add(1, "play");
  add(2, "play");
  read(2);
  EXPECT_EQ(segments(), "play 1-2");
  add(3, "rest");
  add(4, "rest");
  read(3);
  EXPECT_EQ(segments(), "play 1-3, rest 3-3") << "up to the shown instant";
  read(4);
  EXPECT_EQ(segments(), "play 1-3, rest 3-4");
}

TEST_F(OptionHistoryTest, aJumpBackReadsAnew) {
  for (int i = 1; i <= 5; ++i) add(i, i < 4 ? "play" : "rest");
  read(5);
  EXPECT_EQ(segments(), "play 1-4, rest 4-5");
  read(2);
  EXPECT_EQ(segments(), "play 1-2");
  read(0.5);
  EXPECT_EQ(segments(), "nothing");
}

TEST_F(OptionHistoryTest, itLooksBackOneMinute) {
  for (int i = 1; i <= 100; ++i) add(i, i % 2 == 0 ? "play" : "rest");
  read(100);
  const auto& shown = history.rows().at(0).segments;
  EXPECT_GE(shown.front().from, 39);
  EXPECT_EQ(shown.back().to, 100);
  EXPECT_GE(shown.size(), 59U);
}

TEST_F(OptionHistoryTest, anotherStreamOrNoneForgetsWhatWasRead) {
  add(1, "play");
  read(1);
  stored.add("blue1/behavior", 1, inState("rest"));
  history.read(stored.store.find("blue1/behavior"), atSeconds(1));
  EXPECT_EQ(segments(), "rest 1-1");
  history.read(nullptr, atSeconds(1));
  EXPECT_TRUE(history.rows().empty());
}

TEST_F(OptionHistoryTest, anotherPlatformForgetsWhatWasRead) {
  add(1, "play");
  read(1);
  stored.store.clear();
  add(1, "rest");
  read(1);
  EXPECT_EQ(segments(), "rest 1-1");
}

TEST_F(OptionHistoryTest, aBehaviorWithoutOptionsIsOneRow) {
  robotcontrol::BehaviorState message;
  message.set_solution("chase");
  message.set_state("approach");
  stored.add("red1/behavior", 1, message);
  read(1);
  EXPECT_EQ(history.rows().at(0).option, QStringLiteral("chase"));
  EXPECT_EQ(segments(), "approach 1-1");
}

TEST_F(OptionHistoryTest, thePresentIsAtTheRightAndPlacesAreFoundAgain) {
  add(41, "play");
  add(70, "rest");
  add(100, "rest");
  read(100);
  constexpr double kWidth = OptionHistory::kNames + 600;
  const auto& shown = history.rows().at(0).segments;
  ASSERT_EQ(segments(), "play 41-70, rest 70-100");
  const auto at = [&](double x, double y) { return history.at({x, y}, kWidth); };
  const double middle = OptionHistory::kRow / 2, left = OptionHistory::kNames;
  EXPECT_EQ(at(left + 9, middle), nullptr);
  EXPECT_EQ(at(left + 11, middle), &shown[0]);
  EXPECT_EQ(at(left + 299, middle), &shown[0]);
  EXPECT_EQ(at(left + 301, middle), &shown[1]);
  EXPECT_EQ(at(kWidth - 1, middle), &shown[1]);
  EXPECT_EQ(at(left - 1, middle), nullptr) << "there is the name";
  EXPECT_EQ(at(left + 100, middle + OptionHistory::kRow), nullptr);
}

TEST_F(OptionHistoryTest, aToolTipSaysHowLongAndWhy) {
  EXPECT_EQ(OptionHistory::toolTip({1, 3.5, QStringLiteral("play"), {}}), QStringLiteral("play for 2.5 s"));
  EXPECT_EQ(OptionHistory::toolTip({1, 2, QStringLiteral("play"), QStringLiteral("a < b")}),
            QStringLiteral("play for 1.0 s<br>a &lt; b"));
  EXPECT_EQ(OptionHistory::toolTip({1, 2, QStringLiteral("x<y"), QStringLiteral("so")}),
            QStringLiteral("x&lt;y for 1.0 s<br>so"));
}

}  // namespace
}  // namespace widgets::test
