// SPDX-License-Identifier: GPL-3.0-or-later
// The player of a team on plain values: phases, roles, places and what it does with the ball.
#include <gmock/gmock.h>

#include "modules/behavior/PotentialField.h"
#include "modules/behavior/SoccerPlayer.h"
#include "robotlink/config/FieldDescription.h"

namespace modules {
namespace {

using robotlink::Pose2;
using robotlink::Vector2;
using Phase = GameSituation::Phase;

robotlink::FieldDescription field2002() {
  return *robotlink::FieldDescription::load(ROBOTCONTROL_SOURCE_DIR "/resources/fields/2002.yaml");
}

/// The robot stands at a place of its half, the ball lies at another one, and is seen.
GameSituation situation(const Pose2& robot, const Vector2& ball) {
  GameSituation now;
  now.pose = robot;
  now.knowsBall = true;
  now.ball = robot.inverse() * ball;
  return now;
}

Mate mate(int number, Role role, const Vector2& place, double secondsToBall) {
  return {number, role, {place.x(), place.y(), 0}, secondsToBall, true};
}

class SoccerPlayerTest : public testing::Test {
 protected:
  /// Lets some frames pass.
  Intention play(GameSituation now, int frames = 1) {
    Intention last;
    for (int i = 0; i < frames; ++i) {
      now.time = time_ += 0.04;
      last = player_.decide(now);
    }
    return last;
  }
  std::string state(const std::string& option) const {
    for (const auto& active : player_.machine().active())
      if (active.option->name() == option) return active.state->name();
    return "";
  }

  robotlink::FieldDescription field_ = field2002();
  SoccerPlayer player_{field_, {}};
  double time_ = 0;
};

TEST_F(SoccerPlayerTest, withoutARefereeItPlays) {
  const Intention intention = play(situation({-1, 0, 0}, {0, 0}));
  EXPECT_EQ(state("game"), "play");
  EXPECT_EQ(player_.role(), Role::kStriker);
  EXPECT_EQ(intention.motion, Intention::Motion::kWalk);
  EXPECT_GT(intention.forward, 0.1);
}

TEST_F(SoccerPlayerTest, obeysTheReferee) {
  GameSituation now = situation({-1, 0, 0}, {0, 0});
  for (const auto& [phase, name] : {std::pair(Phase::kInitial, "initial"), std::pair(Phase::kReady, "ready"),
                                    std::pair(Phase::kSet, "set"), std::pair(Phase::kPlaying, "play"),
                                    std::pair(Phase::kFinished, "finished")}) {
    now.phase = phase;
    const Intention intention = play(now);
    EXPECT_EQ(state("game"), name);
    const bool walks = phase == Phase::kReady || phase == Phase::kPlaying;
    EXPECT_EQ(intention.motion, walks ? Intention::Motion::kWalk : Intention::Motion::kStand) << name;
  }
  now.phase = Phase::kPlaying;
  now.penalized = true;
  EXPECT_EQ(play(now).motion, Intention::Motion::kStand);
  EXPECT_EQ(state("game"), "penalized");
  now.penalized = false;
  play(now);
  EXPECT_EQ(state("game"), "play");
}

TEST_F(SoccerPlayerTest, walksToItsOwnPlaceForTheKickOffAndStaysThere) {
  GameSituation now = situation({-1.8, 1, 0}, {0, 0});
  now.phase = Phase::kReady;
  now.number = 2;
  now.mates = {mate(1, Role::kGoalie, {-2, 0}, 9)};
  EXPECT_EQ(play(now).motion, Intention::Motion::kWalk);
  const Pose2 place = TeamPlaces(field_, {}).kickOff(2, false);
  EXPECT_NEAR((*player_.target() - now.pose->inverse() * place.translation()).norm(), 0, 1e-9);
  now.pose = place;
  EXPECT_EQ(play(now, 2).motion, Intention::Motion::kStand);
}

TEST_F(SoccerPlayerTest, getsUpAfterAFallAndStandsWhileItIsCarried) {
  GameSituation now = situation({-1, 0, 0}, {0, 0});
  play(now);
  now.fallen = true;
  EXPECT_EQ(play(now).motion, Intention::Motion::kGetUp);
  now.pickedUp = true;
  EXPECT_EQ(play(now).motion, Intention::Motion::kStand);
  now.fallen = now.pickedUp = false;
  EXPECT_EQ(play(now).motion, Intention::Motion::kWalk);
}

TEST_F(SoccerPlayerTest, leavesTheKickOffToTheOtherTeamUntilTheBallRolls) {
  GameSituation now = situation({-0.8, 0, 0}, {0, 0});
  now.ownKickOff = false;
  now.phase = Phase::kSet;
  play(now, 5);
  now.phase = Phase::kPlaying;
  EXPECT_EQ(play(now, 10).motion, Intention::Motion::kStand);
  EXPECT_EQ(state("playing"), "wait");
  now.ball = now.pose->inverse() * Vector2(-0.3, 0.3);
  play(now, 2);
  EXPECT_EQ(state("playing"), "striker");
}

TEST_F(SoccerPlayerTest, waitsForTheOtherTeamNotForever) {
  GameSituation now = situation({-0.8, 0, 0}, {0, 0});
  now.ownKickOff = false;
  now.phase = Phase::kSet;
  play(now, 5);
  now.phase = Phase::kPlaying;
  play(now, 200);
  EXPECT_EQ(state("playing"), "striker");
}

TEST_F(SoccerPlayerTest, theFastestIsTheStrikerAndTheDeepestTheDefender) {
  GameSituation now = situation({-1, 0.5, 0}, {1, 0});
  now.number = 3;
  now.mates = {mate(1, Role::kGoalie, {-1.9, 0}, 20), mate(2, Role::kStriker, {0.5, 0}, 3),
               mate(4, Role::kNone, {-0.3, -0.5}, 9)};
  play(now);
  EXPECT_EQ(player_.role(), Role::kDefender);
  now.mates[2].pose.x = -1.9;
  play(now);
  EXPECT_EQ(player_.role(), Role::kSupporter);
  now.mates[1].secondsToBall = 1000;  // it has fallen
  now.mates[2].secondsToBall = 1000;
  play(now);
  EXPECT_EQ(player_.role(), Role::kStriker);
}

TEST_F(SoccerPlayerTest, theStrikerKeepsItsRoleUntilAnotherIsClearlyFaster) {
  GameSituation now = situation({0, 0, 0}, {1, 0});
  now.number = 2;
  play(now);
  ASSERT_EQ(player_.role(), Role::kStriker);
  now.mates = {mate(3, Role::kNone, {0, 1}, player_.secondsToBall() - 1)};
  play(now);
  EXPECT_EQ(player_.role(), Role::kStriker);
  now.mates[0].secondsToBall -= 2;
  play(now);
  EXPECT_NE(player_.role(), Role::kStriker);
}

TEST_F(SoccerPlayerTest, aStrikerAtTheBallKeepsIt) {
  // It is on the wrong side of the ball, and a mate behind it would be there sooner.
  GameSituation now = situation({0.3, 0, robotlink::kPi}, {0, 0});
  now.number = 2;
  play(now, 2);
  ASSERT_EQ(player_.role(), Role::kStriker);
  EXPECT_LT(player_.secondsToBall(), 0.5);
  now.mates = {mate(3, Role::kSupporter, {-0.5, 0}, 0.8)};
  play(now, 10);
  EXPECT_EQ(player_.role(), Role::kStriker);
  now.ballAge = 1;
  play(now);
  EXPECT_EQ(player_.role(), Role::kStriker) << "it looked up";
  now.ballAge = 6;
  play(now);
  EXPECT_NE(player_.role(), Role::kStriker) << "it does not know where the ball is";
}

TEST_F(SoccerPlayerTest, whoeverDoesNotPlayTheBallMakesWay) {
  GameSituation now = situation({0, 0, 0}, {0.2, 0});
  now.number = 2;
  now.mates = {mate(3, Role::kStriker, {0.1, 0.2}, 0.1)};
  now.robots = {{0.1, 0.2}};
  const Intention leaving = play(now, 10);
  ASSERT_NE(player_.role(), Role::kStriker);
  EXPECT_EQ(leaving.motion, Intention::Motion::kWalk);
  EXPECT_LE(leaving.forward, 0.01);
  EXPECT_EQ(leaving.turn, 0);
}

TEST_F(SoccerPlayerTest, stepsBackFromABallThatTheTeamSeesUnderIt) {
  GameSituation now = situation({0, 0, 0}, {0.15, 0});
  now.number = 2;
  play(now);
  ASSERT_EQ(state("strike"), "approach");
  now.ballAge = 2.1;
  now.ballFromTeam = true;
  now.ball = {0.05, 0};
  const Intention intention = play(now, 20);
  EXPECT_EQ(state("playing"), "uncover");
  EXPECT_LT(intention.forward, 0);
  now.ballAge = 0;
  now.ballFromTeam = false;
  now.ball = {0.25, 0};
  play(now, 2);
  EXPECT_EQ(state("playing"), "striker") << "there it is";
}

TEST_F(SoccerPlayerTest, whoeverCarriesTheBallAlongStepsBackFromIt) {
  GameSituation now = situation({0, 0, 0}, {0.05, 0});
  now.number = 3;
  now.mates = {mate(2, Role::kStriker, {0.5, 0}, 0.1), mate(4, Role::kDefender, {-1, 0}, 9)};
  now.ballAge = 9;
  now.ballFromTeam = true;
  play(now, 5);
  ASSERT_EQ(player_.role(), Role::kSupporter);
  EXPECT_LT(play(now, 20).forward, 0);
  EXPECT_EQ(state("playing"), "uncover");
  play(now, 50);
  EXPECT_EQ(state("playing"), "supporter") << "that did not help, so it goes on";
  now.ball = {0.5, 0};
  play(now, 50);
  EXPECT_EQ(state("playing"), "supporter");
}

TEST_F(SoccerPlayerTest, stepsBackFromABallThatVanishesWhileItPositionsItself) {
  GameSituation now = situation({1.4, 0, 0}, {1.62, 0});
  now.number = 2;
  play(now, 3);
  ASSERT_EQ(state("strike"), "position");
  now.ball = {0.15, 0.06};
  play(now);
  for (int i = 0; i < 25; ++i) {
    now.ballAge += 0.04;
    play(now);
  }
  EXPECT_EQ(state("playing"), "uncover");
}

TEST_F(SoccerPlayerTest, walksToWhereItMeetsARollingBall) {
  GameSituation now = situation({0, -0.5, 0}, {0.5, -0.5});
  now.ballVelocity = {0, 0.2};
  SoccerMind::Options options;
  options.roll = {0, 0.33};
  player_.setOptions(options);
  play(now, 2);
  EXPECT_GT(player_.target()->y(), 0.1) << "it rolls to the left";
  options.interceptTime = 0;
  player_.setOptions(options);
  play(now, 2);
  EXPECT_LT(player_.target()->y(), 0.1);
}

TEST_F(SoccerPlayerTest, kicksARollingBallWhereItWillBe) {
  GameSituation now = situation({1.4, 0, 0}, {1.53, 0});
  now.ballVelocity = {0.3, 0};
  play(now, 2);
  EXPECT_NE(state("strike"), "kick") << "before the kick hits it, it is too far away";
  now.ballVelocity = {0.1, 0};
  play(now, 2);
  EXPECT_EQ(state("strike"), "kick");
}

TEST_F(SoccerPlayerTest, theGoalieStaysInItsGoalAndClearsNearBalls) {
  GameSituation now = situation({-1.9, 0, 0}, {1, 0});
  now.mates = {mate(2, Role::kStriker, {0, 0}, 3)};
  play(now, 5);
  EXPECT_EQ(player_.role(), Role::kGoalie);
  EXPECT_EQ(state("keep goal"), "guard");
  EXPECT_EQ(state("take place"), "stand");
  now.ball = now.pose->inverse() * Vector2(-1.5, 0.1);
  EXPECT_EQ(play(now, 5).motion, Intention::Motion::kWalk);
  EXPECT_EQ(state("keep goal"), "clear");
  now.ball = now.pose->inverse() * Vector2(0, 0.1);
  play(now, 2);
  EXPECT_EQ(state("keep goal"), "guard");
}

TEST_F(SoccerPlayerTest, theGoalieTurnsToABallThatVanishedBesideIt) {
  GameSituation now = situation(TeamPlaces(field_, {}).goalie({-1.2, 0.2}), {-1.2, 0.2});
  now.givenRole = Role::kGoalie;
  play(now, 30);
  EXPECT_EQ(state("keep goal"), "guard");
  now.ball = {0, 0.25};
  play(now);
  EXPECT_EQ(state("keep goal"), "clear");
  now.knowsBall = false;
  const Intention intention = play(now, 20);
  EXPECT_EQ(state("keep goal"), "turn to ball");
  EXPECT_GT(intention.turn, 0.3) << "to the left";
  play(now, 200);
  EXPECT_EQ(state("keep goal"), "guard") << "it does not look for it for ever";
}

TEST_F(SoccerPlayerTest, theStrikerLeavesABallInItsOwnPenaltyAreaToTheGoalie) {
  GameSituation now = situation({-1.2, 0.3, 0}, {-1.8, 0.3});
  now.number = 2;
  play(now);
  EXPECT_EQ(state("playing"), "striker") << "there is nobody else";
  now.mates = {mate(1, Role::kGoalie, {-2, 0}, 2)};
  const Intention intention = play(now, 2);
  EXPECT_EQ(player_.role(), Role::kStriker);
  EXPECT_EQ(state("playing"), "leave");
  EXPECT_FALSE(TeamPlaces(field_, {}).isGoaliesBall(*now.pose * *player_.target(), 0.1));
  EXPECT_NE(intention.motion, Intention::Motion::kKick);
  now.ball = now.pose->inverse() * Vector2(-field_.goalLineX() + field_.penaltyAreaLength + 0.1, 0.3);
  play(now, 2);
  EXPECT_EQ(state("playing"), "leave") << "it comes back when the ball is clearly outside";
  now.ball = now.pose->inverse() * Vector2(-1.2, 0.6);
  play(now, 2);
  EXPECT_EQ(state("playing"), "striker");
}

TEST_F(SoccerPlayerTest, aBallThatLiesBehindItIsWalkedAround) {
  GameSituation now = situation({1, 0, 0}, {0.6, 0});
  play(now, 3);
  ASSERT_TRUE(player_.target());
  EXPECT_GT((*player_.target() - now.ball).norm(), 0.2) << "not through the ball";
  EXPECT_LT(std::abs(*player_.aim()), 1)
      << "it plays toward the goal before it, or past it for a shorter way";
}

TEST_F(SoccerPlayerTest, kicksOnceWhenTheBallIsBeforeItsPawsAndTheGoalAhead) {
  GameSituation now = situation({1.4, 0, 0}, {1.555, 0});
  Intention intention = play(now, 3);
  EXPECT_EQ(state("strike"), "kick");
  EXPECT_EQ(intention.motion, Intention::Motion::kKick);
  EXPECT_FALSE(intention.kick.empty());
  now.playsMotion = true;
  now.stable = false;
  EXPECT_EQ(play(now).motion, Intention::Motion::kStand) << "a request that stays would repeat the kick";
  now.playsMotion = false;
  now.stable = true;
  now.ball = {0.7, 0};
  EXPECT_EQ(play(now, 2).motion, Intention::Motion::kWalk);
}

TEST_F(SoccerPlayerTest, kicksFarOnlyWhenNoOpponentIsNear) {
  SoccerPlayer::Options options;
  options.kick = "quick";
  options.farKick = "far";
  options.kicks.farClearance = 0.5;
  player_.setOptions(options);
  GameSituation now = situation({0.2, 0, 0}, {0.33, 0});
  EXPECT_EQ(play(now, 3).kick, "far");
  SoccerPlayer pressed(field_, options);
  now.opponents = {{0.6, 0.3}};
  now.time += 1;
  (void)pressed.decide(now);
  now.time += 0.04;
  (void)pressed.decide(now);
  now.time += 0.04;
  EXPECT_EQ(pressed.decide(now).kick, "quick");
}

TEST_F(SoccerPlayerTest, searchesAndStandsStillWhenItIsBlind) {
  GameSituation now = situation({0, 0, 0}, {1, 0});
  now.knowsBall = false;
  EXPECT_EQ(play(now, 10).head, Intention::Head::kSearch);
  EXPECT_EQ(play(now, 60).motion, Intention::Motion::kWalk) << "turns";
  now.seesField = false;
  EXPECT_EQ(play(now, 40).motion, Intention::Motion::kStand);
  EXPECT_EQ(state("search"), "blind");
}

TEST_F(SoccerPlayerTest, comesBackFromTheGoal) {
  GameSituation now = situation({2.2, 0, 0}, {0, 0});
  play(now);
  EXPECT_EQ(state("playing"), "return");
  ASSERT_TRUE(player_.target());
  EXPECT_LT((*now.pose * *player_.target()).x(), 2.0);
}

TEST(TeamPlacesTest, aimsAtTheWidestGapOfTheGoal) {
  const TeamPlaces places(field2002(), {});
  EXPECT_NEAR(places.aim({1, 0}, {}).y(), 0, 1e-9);
  EXPECT_LT(places.aim({1, 0}, {{1.9, 0.1}}).y(), -0.05);
  EXPECT_GT(places.aim({1, 0}, {{1.9, -0.1}}).y(), 0.05);
  EXPECT_NEAR(places.aim({1, 0}, {{0.5, 0}}).y(), 0, 1e-9) << "who stands behind the ball is not in the way";
}

TEST(TeamPlacesTest, aSupporterThatIsSentAheadIsAheadEverywhere) {
  const robotlink::FieldDescription field = field2002();
  TeamPlaces::Options options;
  options.supporterBack = -0.6;
  const TeamPlaces places(field, options);
  for (const double x : {-1.5, -0.5, 0.5}) EXPECT_NEAR(places.supporter({x, 0.2}).x, x + 0.6, 1e-9) << x;
}

TEST(TeamPlacesTest, playersStandBetweenTheBallAndTheirGoal) {
  const TeamPlaces places(field2002(), {});
  for (const Vector2& ball : {Vector2(0, 0), Vector2(-1, 0.8), Vector2(1.5, -1)}) {
    const Pose2 goalie = places.goalie(ball), defender = places.defender(ball);
    EXPECT_LT(goalie.x, -1.7);
    EXPECT_LT(std::abs(goalie.y), 0.3);
    EXPECT_LT(goalie.x, defender.x);
    EXPECT_GE(places.supporter(ball).x, -1.6);
    EXPECT_FALSE(places.isOutside(places.supporter(ball).translation()));
  }
  EXPECT_LT(places.kickOff(1, true).x, places.kickOff(2, false).x);
}

class PotentialFieldTest : public testing::Test {
 protected:
  PotentialField field_{field2002()};
};

TEST_F(PotentialFieldTest, theBallAttractsAndRobotsRepel) {
  GameSituation now = situation({-1, 0, 0}, {0.5, 0});
  EXPECT_GT(field_.force(now, {0, 0}).x(), 0.1);
  EXPECT_NEAR(field_.force(now, {0, 0}).y(), 0, 1e-9);
  now.robots = {{0.2, 0.05}};
  EXPECT_LT(field_.force(now, {0, 0}).x(), 0.1);
  EXPECT_LT(field_.force(now, {0, 0}).y(), 0);
}

TEST_F(PotentialFieldTest, onTheWrongSideOfTheBallItGoesAroundIt) {
  const GameSituation now = situation({0.4, 0.02, robotlink::kPi}, {0, 0});
  const Vector2 force = field_.force(now, {0, 0});
  EXPECT_GT(std::abs(force.y()), 2 * std::abs(force.x()));
}

TEST_F(PotentialFieldTest, kicksOnceAndOnlyTowardTheGoal) {
  GameSituation now = situation({1, 0, 0}, {1.155, 0});
  EXPECT_EQ(field_.decide(now).motion, Intention::Motion::kKick);
  now.playsMotion = true;
  EXPECT_EQ(field_.decide(now).motion, Intention::Motion::kStand);
  now = situation({-1, 0, robotlink::kPi}, {-1.155, 0});
  EXPECT_EQ(field_.decide(now).motion, Intention::Motion::kWalk);
  now.penalized = true;
  EXPECT_EQ(field_.decide(now).motion, Intention::Motion::kStand);
}

TEST_F(SoccerPlayerTest, besideTheBallItLooksUpForBeaconsNowAndThen) {
  GameSituation now = situation({-0.3, 0.2, 0}, {0, 0});
  const auto looksUp = [&] { return play(now).head == Intention::Head::kLookAround; };
  now.landmarkAge = 0.5;
  for (int i = 0; i < 50; ++i) EXPECT_FALSE(looksUp());
  now.landmarkAge = 2;
  EXPECT_TRUE(looksUp());
  // A ball that it does not see meanwhile is not one under its body.
  now.ballAge = 0.7;
  now.ball = {0.16, 0};
  play(now, 30);
  EXPECT_NE(state("playing"), "uncover");
  now.ballAge = 0;
  EXPECT_FALSE(looksUp());
}

}  // namespace
}  // namespace modules
