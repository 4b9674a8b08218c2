// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/truth/EventErrors.h"

#include <gtest/gtest.h>

#include <vector>

#include "robotlink/truth/ErrorQuantity.h"

namespace robotlink {
namespace {

using std::chrono::milliseconds;

class EventErrorsTest : public testing::Test {
 protected:
  /// Adds frames for some time, from where the last ones ended.
  void pass(int ms, bool happens, bool isReported) {
    for (const Instant end = now_ + milliseconds(ms); now_ < end; now_ += milliseconds(10))
      if (const auto delay = events_.add(now_, happens, isReported, errors_)) delays_.push_back(*delay);
  }
  const ErrorCounts& counts() const { return errors_.own; }

  Instant now_{std::chrono::seconds(1)};
  EventErrors events_;
  ErrorQuantity errors_;
  std::vector<Duration> delays_;
};

TEST_F(EventErrorsTest, anEventThatIsReportedLateHasADelayAndIsNotMissed) {
  pass(1000, false, false);
  pass(400, true, false);
  pass(600, true, true);
  pass(200, false, true);
  pass(3000, false, false);
  EXPECT_EQ(counts().there, 1U);
  EXPECT_EQ(counts().missed, 0U);
  EXPECT_EQ(counts().reported, 1U);
  EXPECT_EQ(counts().invented, 0U);
  ASSERT_EQ(delays_.size(), 1U);
  EXPECT_EQ(delays_.front(), milliseconds(400));
  EXPECT_NEAR(errors_.amounts.mean(), 600.0 / 5200, 1e-9) << "wrong before it was reported, and afterwards";
}

TEST_F(EventErrorsTest, whatNobodyReportsIsMissedOnce) {
  pass(500, true, false);
  pass(500, false, false);
  pass(500, true, false);
  EXPECT_EQ(counts().there, 0U) << "it may still be reported";
  pass(2000, false, false);
  EXPECT_EQ(counts().there, 1U) << "a short pause does not make two events of it";
  EXPECT_EQ(counts().missed, 1U);
  pass(5000, true, false);
  EXPECT_EQ(counts().missed, 2U) << "one that goes on does not have to end";
}

TEST_F(EventErrorsTest, aMomentNeedNotBeReported) {
  pass(100, true, false);
  pass(3000, false, false);
  EXPECT_EQ(counts().there, 0U);
}

TEST_F(EventErrorsTest, anAlarmWithoutAnEventIsFalse) {
  pass(50, false, true);
  pass(500, false, false);
  pass(50, false, true);
  EXPECT_EQ(counts().reported, 0U) << "it may still happen";
  pass(3000, false, false);
  EXPECT_EQ(counts().reported, 1U);
  EXPECT_EQ(counts().invented, 1U);
  pass(50, false, true);
  pass(500, true, false);
  pass(3000, false, false);
  EXPECT_EQ(counts().reported, 2U);
  EXPECT_EQ(counts().invented, 1U) << "an alarm just before its event is right";
}

TEST_F(EventErrorsTest, aGapForgetsWhatWasGoingOn) {
  pass(2000, true, false);
  now_ += std::chrono::seconds(30);
  pass(3000, false, false);
  EXPECT_EQ(counts().there, 0U);
}

}  // namespace
}  // namespace robotlink
