// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/modeling/PlayerTracker.h"

#include <gtest/gtest.h>

#include <array>

#include "modules/modeling/ReportedMates.h"

namespace modules {
namespace {

TEST(PlayerTracker, joinsPerceptsOfOneRobotAndKeepsTeamsApart) {
  PlayerTracker tracker({});
  const std::array seen{TrackedPlayer{"blue", {1, 0}, 0.5}, TrackedPlayer{"red", {1.1, 0}, 0.5}};
  tracker.update(0, seen);
  const std::array again{TrackedPlayer{"blue", {1.2, 0}, 0.5}};
  tracker.update(0.04, again);
  ASSERT_EQ(tracker.players().size(), 2U);
  EXPECT_EQ(tracker.players()[0].team, "blue");
  EXPECT_NEAR(tracker.players()[0].positionInField.x(), 1.08, 1e-9);
  EXPECT_GT(tracker.players()[0].confidence, 0.5);
}

TEST(PlayerTracker, addsARobotThatIsElsewhere) {
  PlayerTracker tracker({});
  const std::array seen{TrackedPlayer{"blue", {1, 0}, 0.5}, TrackedPlayer{"blue", {1, 1}, 0.6}};
  tracker.update(0, seen);
  ASSERT_EQ(tracker.players().size(), 2U);
  EXPECT_DOUBLE_EQ(tracker.players()[0].confidence, 0.6);
}

TEST(PlayerTracker, forgetsWhatIsNotSeenAgain) {
  PlayerTracker tracker({});
  const std::array seen{TrackedPlayer{"blue", {1, 0}, 0.5}};
  tracker.update(0, seen);
  tracker.update(2, {});
  ASSERT_EQ(tracker.players().size(), 1U);
  EXPECT_NEAR(tracker.players()[0].confidence, 0.25, 1e-9);
  tracker.update(6, {});
  EXPECT_TRUE(tracker.players().empty());
}

TEST(ReportedMates, areWhereTheySayAndOthersWhereTheyWereSeen) {
  const std::array told{robotlink::Vector2(1, 0)};
  const auto players = withReportedMates(
      {{"red", {1.3, 0.2}, 0.5}, {"red", {-1, 0}, 0.4}, {"blue", {1.1, 0}, 0.3}}, "red", told);
  ASSERT_EQ(players.size(), 3U);
  EXPECT_EQ(players[0].positionInField, robotlink::Vector2(-1, 0));
  EXPECT_EQ(players[1].team, "blue");
  EXPECT_EQ(players[2].team, "red");
  EXPECT_EQ(players[2].positionInField, told[0]);
}

}  // namespace
}  // namespace modules
