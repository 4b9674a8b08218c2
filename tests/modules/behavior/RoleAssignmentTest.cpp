// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/behavior/RoleAssignment.h"

#include <gtest/gtest.h>

namespace modules {
namespace {

Mate mate(int number, Role role, double secondsToBall, double x = 0) {
  Mate result;
  result.number = number;
  result.role = role;
  result.secondsToBall = secondsToBall;
  result.pose = {x, 0, 0};
  return result;
}

GameSituation player(int number, double x = 0) {
  GameSituation now;
  now.number = number;
  now.pose = robotlink::Pose2{x, 0, 0};
  return now;
}

TEST(RoleAssignment, aPlayerAloneScores) {
  RoleAssignment roles({});
  EXPECT_EQ(roles.decide(player(1), 100), Role::kStriker);
  EXPECT_EQ(roles.decide(player(3), 100), Role::kStriker);
}

TEST(RoleAssignment, theSceneHasTheLastWord) {
  for (const Role given : {Role::kGoalie, Role::kDefender, Role::kSupporter, Role::kStriker}) {
    RoleAssignment roles({});
    GameSituation now = player(1);
    now.givenRole = given;
    now.mates = {mate(2, Role::kStriker, 0)};
    EXPECT_EQ(roles.decide(now, 50), given);
    EXPECT_EQ(roles.role(), given);
  }
}

TEST(RoleAssignment, numberOneOfSeveralKeepsTheGoal) {
  RoleAssignment roles({});
  GameSituation now = player(1);
  now.mates = {mate(2, Role::kStriker, 20)};
  EXPECT_EQ(roles.decide(now, 0), Role::kGoalie) << "even if it has the ball first";
  now.mates = {mate(2, Role::kGoalie, 20)};
  RoleAssignment late({});
  EXPECT_NE(late.decide(now, 0), Role::kGoalie) << "another one keeps it already";
}

TEST(RoleAssignment, aGoalieThatHearsNobodyLeavesItsGoalAfterAWhile) {
  RoleAssignment roles({.lonelyAfter = 30});
  GameSituation now = player(1);
  now.time = 100;
  now.mates = {mate(2, Role::kStriker, 1)};
  ASSERT_EQ(roles.decide(now, 5), Role::kGoalie);
  now.mates.clear();
  now.time = 129;
  EXPECT_EQ(roles.decide(now, 5), Role::kGoalie);
  now.time = 131;
  EXPECT_EQ(roles.decide(now, 5), Role::kStriker);
  // When the others are heard again, it is not in its goal, but goes there.
  now.mates = {mate(2, Role::kStriker, 1)};
  EXPECT_EQ(roles.decide(now, 5), Role::kGoalie);
}

TEST(RoleAssignment, whoHasTheBallFirstIsTheStriker) {
  GameSituation now = player(2, 0.5);
  now.mates = {mate(3, Role::kNone, 4, -1)};
  EXPECT_EQ(RoleAssignment({}).decide(now, 3), Role::kStriker);
  EXPECT_NE(RoleAssignment({}).decide(now, 5), Role::kStriker);
  // Equals agree on the one with the smaller number.
  EXPECT_EQ(RoleAssignment({}).decide(now, 4), Role::kStriker);
  GameSituation other = player(3, 0.5);
  other.mates = {mate(2, Role::kNone, 4, -1)};
  EXPECT_NE(RoleAssignment({}).decide(other, 4), Role::kStriker);
}

TEST(RoleAssignment, theStrikerKeepsItsRoleUntilAnotherIsClearlyFaster) {
  RoleAssignment roles({.strikerAdvantage = 2});
  GameSituation now = player(2);
  ASSERT_EQ(roles.decide(now, 5), Role::kStriker);
  now.mates = {mate(3, Role::kSupporter, 4)};
  EXPECT_EQ(roles.decide(now, 5), Role::kStriker);
  now.mates = {mate(3, Role::kSupporter, 2.9)};
  EXPECT_NE(roles.decide(now, 5), Role::kStriker);
  // Now the other one is the striker, and has the advantage.
  now.mates = {mate(3, Role::kStriker, 4)};
  EXPECT_NE(roles.decide(now, 3), Role::kStriker);
  EXPECT_EQ(roles.decide(now, 1.9), Role::kStriker);
}

TEST(RoleAssignment, ofTheOthersTheHindmostDefends) {
  GameSituation now = player(2, -1);
  now.mates = {mate(3, Role::kStriker, 0, -2), mate(4, Role::kNone, 9, 0), mate(1, Role::kGoalie, 9, -3)};
  EXPECT_EQ(RoleAssignment({}).decide(now, 9), Role::kDefender) << "neither goalie nor striker compete";
  now.pose = robotlink::Pose2{0.5, 0, 0};
  EXPECT_EQ(RoleAssignment({}).decide(now, 9), Role::kSupporter);
}

TEST(RoleAssignment, theDefenderKeepsItsRoleUntilAnotherIsClearlyNearerToTheGoal) {
  RoleAssignment roles({.defenderAdvantage = 0.3});
  GameSituation now = player(2, -1);
  now.mates = {mate(3, Role::kStriker, 0, 1), mate(4, Role::kSupporter, 9, 0)};
  ASSERT_EQ(roles.decide(now, 9), Role::kDefender);
  now.mates[1].pose.x = -1.2;
  EXPECT_EQ(roles.decide(now, 9), Role::kDefender);
  now.mates[1].pose.x = -1.4;
  EXPECT_EQ(roles.decide(now, 9), Role::kSupporter);
}

TEST(RoleAssignment, aPlayerWithoutAPlaceCountsAsInTheMiddle) {
  GameSituation now = player(2);
  now.pose.reset();
  now.mates = {mate(3, Role::kStriker, 0), mate(4, Role::kSupporter, 9, -1)};
  EXPECT_EQ(RoleAssignment({}).decide(now, 9), Role::kSupporter);
  now.mates[1].pose.x = 1;
  EXPECT_EQ(RoleAssignment({}).decide(now, 9), Role::kDefender);
}

/// Whoever decides, with the same messages, comes to roles that fit together.
TEST(RoleAssignment, fourPlayersAgree) {
  std::vector<Mate> team = {mate(1, Role::kNone, 9, -2), mate(2, Role::kNone, 3, 0.5),
                            mate(3, Role::kNone, 5, -1), mate(4, Role::kNone, 6, -0.5)};
  std::vector<RoleAssignment> minds(4, RoleAssignment({}));
  for (int round = 0; round < 3; ++round) {
    const std::vector<Mate> heard = team;
    for (std::size_t i = 0; i < team.size(); ++i) {
      GameSituation now = player(team[i].number, team[i].pose.x);
      now.time = round;
      for (const Mate& other : heard)
        if (other.number != now.number) now.mates.push_back(other);
      team[i].role = minds[i].decide(now, team[i].secondsToBall);
    }
  }
  EXPECT_EQ(team[0].role, Role::kGoalie);
  EXPECT_EQ(team[1].role, Role::kStriker);
  EXPECT_EQ(team[2].role, Role::kDefender);
  EXPECT_EQ(team[3].role, Role::kSupporter);
}

}  // namespace
}  // namespace modules
