// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/game/GameMachine.h"

#include <gmock/gmock.h>

#include "simcore/world/StateStream.h"

using namespace app;
using Phase = GameMachine::Phase;
using std::chrono::seconds;

namespace {

/// Rules with short times.
GameRules shortRules() {
  GameRules rules;
  rules.teams = {"red", "blue"};
  rules.half = seconds(20);
  rules.pause = seconds(5);
  rules.initial = seconds(1);
  rules.ready = seconds(3);
  rules.set = seconds(2);
  return rules;
}

/// Follows what is due for some time; returns the phases that began.
std::vector<Phase> follow(GameMachine& machine, int forSeconds) {
  std::vector<Phase> began;
  for (int i = 0; i < forSeconds; ++i) {
    machine.pass(seconds(1));
    if (const auto next = machine.due()) {
      EXPECT_TRUE(machine.enter(*next));
      began.push_back(*next);
    }
  }
  return began;
}

}  // namespace

TEST(GameMachine, thePhasesFollowEachOtherOverTwoHalves) {
  const GameRules rules = shortRules();
  GameMachine machine(rules);
  EXPECT_THAT(follow(machine, 6), testing::ElementsAre(Phase::kReady, Phase::kSet, Phase::kPlaying));
  EXPECT_EQ(machine.left(), seconds(15)) << "the clock ran since READY";
  EXPECT_EQ(machine.kickOff(), 0U);
  EXPECT_THAT(follow(machine, 15), testing::ElementsAre(Phase::kFinished));
  EXPECT_FALSE(machine.isOver());
  EXPECT_THAT(follow(machine, 10), testing::ElementsAre(Phase::kReady, Phase::kSet, Phase::kPlaying));
  EXPECT_EQ(machine.half(), 2U);
  EXPECT_EQ(machine.kickOff(), 1U) << "the other team begins the second half";
  EXPECT_THAT(follow(machine, 30), testing::ElementsAre(Phase::kFinished));
  EXPECT_TRUE(machine.isOver());
  EXPECT_EQ(machine.left(), seconds(0));
}

TEST(GameMachine, aGoalGivesTheOtherTeamTheKickOff) {
  const GameRules rules = shortRules();
  GameMachine machine(rules);
  machine.score(0);
  EXPECT_EQ(machine.goals(0), 1U);
  EXPECT_EQ(machine.kickOff(), 1U);
  machine.score(1);
  machine.score(1);
  EXPECT_EQ(machine.goals(1), 2U);
  EXPECT_EQ(machine.kickOff(), 0U);
  machine.restart();
  EXPECT_EQ(machine.goals(0) + machine.goals(1), 0U);
}

TEST(GameMachine, refusesPhasesThatAreOutOfOrder) {
  GameRules rules = shortRules();
  rules.halves = 1;
  GameMachine machine(rules);
  ASSERT_TRUE(machine.enter(Phase::kPlaying)) << "a person may begin at once";
  ASSERT_TRUE(machine.enter(Phase::kFinished));
  EXPECT_EQ(machine.enter(Phase::kReady).error().id, "game.over");
  rules.halves = 2;
  EXPECT_EQ(machine.enter(Phase::kPlaying).error().id, "game.half");
  EXPECT_TRUE(machine.enter(Phase::kReady));
  EXPECT_EQ(machine.half(), 2U);
}

TEST(GameMachine, sidesAreSwitchedOnlyIfTheRulesSaySo) {
  GameRules rules = shortRules();
  rules.switchSides = true;
  GameMachine machine(rules);
  EXPECT_EQ(machine.direction(0), 1);
  EXPECT_EQ(machine.direction(1), -1);
  EXPECT_EQ(machine.attackerOf(1), 0U);
  ASSERT_TRUE(machine.enter(Phase::kFinished));
  ASSERT_TRUE(machine.enter(Phase::kReady));
  EXPECT_EQ(machine.direction(0), -1);
  EXPECT_EQ(machine.attackerOf(1), 1U);
  rules.switchSides = false;
  EXPECT_EQ(machine.direction(0), 1);
}

TEST(GameMachine, isKeptInSnapshots) {
  const GameRules rules = shortRules();
  GameMachine machine(rules);
  follow(machine, 8);
  machine.score(1);
  std::vector<std::uint8_t> bytes;
  simcore::StateStream out(bytes);
  machine.transfer(out);
  GameMachine other(rules);
  simcore::StateStream in(bytes, simcore::StateStream::Trust::kForeign);
  other.transfer(in);
  EXPECT_TRUE(in.complete());
  EXPECT_EQ(other.phase(), machine.phase());
  EXPECT_EQ(other.left(), machine.left());
  EXPECT_EQ(other.goals(1), 1U);
  bytes.resize(bytes.size() - 1);
  simcore::StateStream damaged(bytes, simcore::StateStream::Trust::kForeign);
  other.transfer(damaged);
  EXPECT_FALSE(damaged.good());
}
