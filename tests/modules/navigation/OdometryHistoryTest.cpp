// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/navigation/OdometryHistory.h"

#include <gtest/gtest.h>

namespace modules {
namespace {

using robotlink::Instant;
using robotlink::Pose2;

Instant historyAt(double seconds) {
  return Instant(robotlink::fromSeconds(seconds));
}

TEST(OdometryHistory, tellsWhereTheRobotWasBetweenTwoMessages) {
  OdometryHistory history;
  EXPECT_FALSE(history.at(historyAt(0)).has_value());
  EXPECT_TRUE(history.add(historyAt(1), {0, 0, 3.0}));
  EXPECT_TRUE(history.add(historyAt(1.1), Pose2{0, 0, 3.0} * Pose2{0.1, 0, 0.4}));
  const auto pose = history.at(historyAt(1.05));
  ASSERT_TRUE(pose.has_value());
  const Pose2 moved = Pose2{0, 0, 3.0}.inverse() * *pose;
  EXPECT_NEAR(0.05, moved.x, 1e-9);
  EXPECT_NEAR(0.2, moved.heading, 1e-9);
}

TEST(OdometryHistory, answersALittleBeyondItsEndsOnly) {
  OdometryHistory history;
  history.add(historyAt(10), {1, 0, 0});
  history.add(historyAt(10.1), {1.05, 0, 0});
  EXPECT_EQ(1, history.at(historyAt(9.9))->x);
  EXPECT_EQ(1.05, history.at(historyAt(10.3))->x);
  EXPECT_FALSE(history.at(historyAt(12)).has_value());
  EXPECT_FALSE(history.at(historyAt(8)).has_value());
}

TEST(OdometryHistory, beginsAnewWhereTheOdometryWasSetOrTimeWentBack) {
  OdometryHistory history;
  history.add(historyAt(10), {5, 0, 0});
  EXPECT_FALSE(history.add(historyAt(10.1), {0, 0, 0}));
  EXPECT_EQ(0, history.at(historyAt(10))->x);
  EXPECT_FALSE(history.add(historyAt(3), {0, 0, 0}));
  EXPECT_FALSE(history.at(historyAt(10)).has_value());
}

TEST(OdometryHistory, forgets) {
  OdometryHistory history;
  for (int i = 0; i < 10'000; ++i) history.add(historyAt(0.1 * i), {0.01 * i, 0, 0});
  EXPECT_FALSE(history.at(historyAt(990)).has_value());
  EXPECT_NEAR(99.8, history.at(historyAt(998))->x, 1e-6);
}

}  // namespace
}  // namespace modules
