// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/behavior/TeamPlaces.h"

#include <gtest/gtest.h>

#include "robotlink/config/FieldDescription.h"

namespace modules {
namespace {

using robotlink::Pose2;
using robotlink::Vector2;

/// 4 m by 2 m, with goals of 0.6 m and ramps of 0.3 m in the corners.
robotlink::FieldDescription teamField() {
  robotlink::FieldDescription field;
  field.length = 4;
  field.width = 2;
  field.goalWidth = 0.6;
  field.penaltyAreaLength = 0.5;
  field.penaltyAreaWidth = 1;
  field.cornerTriangleSide = 0.3;
  field.kickOff = {{-1.8, 0, 0}, {-0.3, 0.5, 0}, {-1, -0.5, 0}};
  return field;
}

const TeamPlaces& places() {
  static const TeamPlaces kPlaces(teamField(), {});
  return kPlaces;
}

TEST(TeamPlaces, rolesHaveWordsAndWordsHaveRoles) {
  for (const Role role : {Role::kNone, Role::kGoalie, Role::kDefender, Role::kSupporter, Role::kStriker})
    EXPECT_EQ(roleOf(name(role)), role) << name(role);
  EXPECT_EQ(roleOf("Striker"), Role::kNone);
  EXPECT_EQ(roleOf("coach"), Role::kNone);
}

TEST(TeamPlaces, theGoalieHasTheHindmostPlaceAtTheKickOff) {
  EXPECT_EQ(places().kickOff(1, true).x, -1.8);
  // Number 2 stands next to the opponents.
  EXPECT_EQ(places().kickOff(2, false).x, -0.3);
  EXPECT_EQ(places().kickOff(3, false).x, -1);
  // More players than places share them.
  EXPECT_EQ(places().kickOff(4, false).x, -0.3);
  EXPECT_EQ(places().kickOff(1, false).x, -0.3);
}

TEST(TeamPlaces, aFieldWithoutPlacesHasOneInTheOwnHalf) {
  robotlink::FieldDescription field = teamField();
  field.kickOff.clear();
  const TeamPlaces bare(field, {});
  EXPECT_DOUBLE_EQ(bare.kickOff(2, false).x, -0.8);
  EXPECT_DOUBLE_EQ(bare.kickOff(1, true).x, -0.8);
}

TEST(TeamPlaces, theGoalieStandsBetweenBallAndGoal) {
  const Pose2 ahead = places().goalie({0, 0});
  EXPECT_DOUBLE_EQ(ahead.x, -1.8);
  EXPECT_DOUBLE_EQ(ahead.y, 0);
  EXPECT_DOUBLE_EQ(ahead.heading, 0);
  // On the line from the middle of the goal to the ball.
  const Pose2 aside = places().goalie({0, 1});
  EXPECT_NEAR(aside.y, 0.1, 1e-9);
  EXPECT_GT(aside.heading, 0);
}

TEST(TeamPlaces, theGoalieStaysInItsGoalAndDoesNotTurnAway) {
  struct Case {
    const char* what;
    Vector2 ball;
  };
  for (const Case& one : {Case{"beside the goal", {-1.99, 0.9}}, Case{"behind the line", {-2.1, -0.9}},
                          Case{"in the corner", {-2, 1}}}) {
    const Pose2 pose = places().goalie(one.ball);
    EXPECT_LE(std::abs(pose.y), 0.22 + 1e-9) << one.what;
    EXPECT_LE(std::abs(pose.heading), 1.2) << one.what;
    EXPECT_EQ(pose.y > 0, one.ball.y() > 0) << one.what;
  }
}

TEST(TeamPlaces, theDefenderLeavesThePenaltyAreaToTheGoalie) {
  const Pose2 pose = places().defender({1, 0});
  EXPECT_NEAR(pose.x, -0.2, 1e-9);  // never in the other half
  EXPECT_NEAR(places().defender({-0.2, 0}).x, -1.1, 1e-9);
  EXPECT_NEAR(places().defender({-1.9, 0.2}).x, -1.3, 1e-9);
  EXPECT_NEAR(places().defender({0, 0.5}).heading,
              std::atan2(0.5 - places().defender({0, 0.5}).y, 0.0 - places().defender({0, 0.5}).x), 1e-9);
}

TEST(TeamPlaces, theSupporterIsOnTheWiderSide) {
  EXPECT_LT(places().supporter({0.5, 0.6}).y, 0.6);
  EXPECT_GT(places().supporter({0.5, -0.6}).y, -0.6);
  EXPECT_NEAR(places().supporter({0.5, -0.6}).x, 0, 1e-9);
  // Never in the own penalty area, nor at the wall.
  EXPECT_GE(places().supporter({-1.9, 0}).x, -1.3 - 1e-9);
  EXPECT_LE(std::abs(places().supporter({0, -0.2}).y), 0.75 + 1e-9);
  const auto beforeGoal = places().supporter({1.8, 1.1});
  EXPECT_NEAR(beforeGoal.y, -0.1, 1e-9) << "a ball in the corner comes back before the goal";
  EXPECT_NEAR(beforeGoal.x, places().opponentGoal().x() - 0.9, 1e-9);
  EXPECT_GT(places().supporter({-1.5, 0.3}).x, -1.2) << "near the own goal it stands before the ball";
}

TEST(TeamPlaces, theBallIsPlayedToTheWidestGap) {
  struct Case {
    const char* what;
    std::vector<Vector2> robots;
    double low, high;
  };
  const Case cases[] = {
      {"nobody", {}, -1e-9, 1e-9},
      {"one on the left", {{1.9, 0.15}}, -0.22, -0.05},
      {"one on the right", {{1.9, -0.15}}, 0.05, 0.22},
      {"one behind the ball does not count", {{0.5, 0}}, -1e-9, 1e-9},
      {"one behind the goal does not count", {{2.3, 0.1}}, -1e-9, 1e-9},
      {"all is covered: the middle", {{1.9, -0.15}, {1.9, 0}, {1.9, 0.15}}, -1e-9, 1e-9},
  };
  for (const Case& one : cases) {
    const Vector2 aim = places().aim({1, 0}, one.robots);
    EXPECT_EQ(aim.x(), 2) << one.what;
    EXPECT_GE(aim.y(), one.low) << one.what;
    EXPECT_LE(aim.y(), one.high) << one.what;
  }
}

TEST(TeamPlaces, theGoaliesBallIsNearItsGoal) {
  EXPECT_TRUE(places().isGoaliesBall({-1.8, 0}, 0));
  EXPECT_FALSE(places().isGoaliesBall({-1.4, 0}, 0));
  EXPECT_TRUE(places().isGoaliesBall({-1.4, 0}, 0.2));
  EXPECT_FALSE(places().isGoaliesBall({-1.8, 0.6}, 0));
  EXPECT_TRUE(places().isGoaliesBall({-1.8, -0.6}, 0.2));
}

TEST(TeamPlaces, placesAreKeptAwayFromWallsAndRamps) {
  EXPECT_EQ(places().inside({3, -2}), Vector2(1.75, -0.75));
  EXPECT_EQ(places().inside({0.5, 0.5}), Vector2(0.5, 0.5));
  EXPECT_TRUE(places().isOutside({2.1, 0}));
  EXPECT_TRUE(places().isOutside({0, -1.1}));
  EXPECT_FALSE(places().isOutside({1.9, 0.9}));
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0}) {
      const Vector2 corner = places().reachable({3 * x, 3 * y});
      // As far from the middle as from the other sides, and on the side of the wish.
      EXPECT_GT(corner.x() * x, 0);
      EXPECT_GT(corner.y() * y, 0);
      EXPECT_LT(std::abs(corner.x()) + std::abs(corner.y()), 2 + 1 - 0.3);
    }
  EXPECT_EQ(places().reachable({1, 0}), Vector2(1, 0));
}

}  // namespace
}  // namespace modules
