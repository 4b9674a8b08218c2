// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/game/GameRules.h"
#include "app/platforms/simulated/game/Referee.h"

#include <gmock/gmock.h>

#include "robotlink/debugging/SharedDebugQueue.h"
#include "simcore/Snapshot.h"
#include "tests/app/Requests.h"
#include "tests/app/platforms/simulated/game/GameOf2002.h"

using namespace app;
using namespace app::test;
using robotcontrol::ControlGame;
using robotlink::Pose2;
using testing::HasSubstr;
using Phase = GameMachine::Phase;

TEST(Referee, theRobotsHaveTeamsNumbersAndRolesOfTheScene) {
  const GameOf2002 game(GameOf2002::options("game2002"));
  const auto& players = game.referee().players();
  ASSERT_EQ(players.size(), 8U);
  EXPECT_EQ(players[0].robot, "red1");
  EXPECT_EQ(players[0].number, 1U);
  EXPECT_TRUE(players[0].isGoalie());
  EXPECT_EQ(players[5].robot, "blue2");
  EXPECT_EQ(players[5].team, 1U);
  EXPECT_EQ(players[5].number, 2U);
  EXPECT_EQ(players[5].fieldIndex, 0U);
}

TEST(Referee, beginsWithAKickOffAtWhichAllStandInTheirOwnHalf) {
  GameOf2002 game;
  game.place("red2", {0.5, -0.8, 2});
  game.place("ball", {1, 1, 0});
  game.playUntil(Phase::kSet);
  EXPECT_NEAR(game.poseOf("ball").translation().norm(), 0, 0.01);
  EXPECT_NEAR(game.poseOf("red2").x, -0.35, 0.02);
  EXPECT_NEAR(game.poseOf("blue2").x, 0.8, 0.02) << "the team without the kick-off stands back";
  EXPECT_NEAR(game.poseOf("blue1").x, 1.85, 0.02);
  game.playUntil(Phase::kPlaying);
  EXPECT_GT(game.referee().machine().left(), std::chrono::seconds(110));
}

TEST(Referee, countsAGoalAndGivesTheOtherTeamTheKickOff) {
  GameOf2002 game;
  game.playUntil(Phase::kPlaying);
  game.place("ball", {2.25, 0.1, 0});
  game.run->step();
  EXPECT_TRUE(game.said("Goal for the red team! Red 1, blue 0."));
  EXPECT_EQ(game.run->game()->goals(), (std::map<std::string, int>{{"blue", 0}, {"red", 1}}));
  EXPECT_EQ(game.phase(), Phase::kReady);
  game.playUntil(Phase::kSet);
  EXPECT_NEAR(game.poseOf("ball").translation().norm(), 0, 0.01);
  EXPECT_NEAR(game.poseOf("blue2").x, 0.35, 0.02) << "blue kicks off";
  EXPECT_NEAR(game.poseOf("red2").x, -0.8, 0.02);
  game.playUntil(Phase::kPlaying);
  EXPECT_EQ(game.run->game()->goals().at("red"), 1) << "it counts once";
}

TEST(Referee, bringsBackABallThatIsOutOrStuck) {
  GameOf2002 game;
  game.playUntil(Phase::kPlaying);
  game.place("ball", {1, 1.8, 0});
  game.play(1.5);
  EXPECT_TRUE(game.said("The ball left the field."));
  EXPECT_NEAR(game.poseOf("ball").x, 1, 0.15);
  EXPECT_LT(game.poseOf("ball").y, 1.2);
  EXPECT_EQ(game.phase(), Phase::kPlaying);
  const Pose2 before = game.poseOf("ball");
  game.play(20.5);
  EXPECT_TRUE(game.said("The ball was stuck; it lies elsewhere now."));
  EXPECT_GT((game.poseOf("ball").translation() - before.translation()).norm(), 0.25);
}

TEST(Referee, penalizesARobotThatHasLeftAndLetsItReturn) {
  GameOf2002 game;
  game.playUntil(Phase::kPlaying);
  game.place("red2", {0.6, 1.75, 0});
  game.play(4.5);
  EXPECT_FALSE(game.said("red2 is penalized for 30 s: leaving."));
  game.play(1);
  EXPECT_TRUE(game.said("red2 is penalized for 30 s: leaving."));
  EXPECT_LT(game.poseOf("red2").y, -1.5) << "it stands beside the field";
  const auto status = game.run->gameStatus();
  ASSERT_EQ(status->state().penalties_size(), 1);
  EXPECT_EQ(status->state().penalties(0).robot(), "red2");
  EXPECT_NEAR(status->state().penalties(0).seconds(), 30, 1);
  game.place("red2", {0.5, 2, 0});
  game.play(0.2);
  EXPECT_LT(game.poseOf("red2").y, -1.5) << "who walks away is carried back";
  game.play(30);
  EXPECT_TRUE(game.said("red2 plays again."));
  EXPECT_LT(std::abs(game.poseOf("red2").y), 1.35);
  EXPECT_LT(game.poseOf("red2").x, 0) << "in its own half";
  EXPECT_EQ(game.referee().tallyOf(1).penalties, 1U);
}

TEST(Referee, doesWhatAPersonAsksFor) {
  GameOf2002 game;
  robotcontrol::ControlGame off;
  off.set_action(ControlGame::AUTOMATIC);
  ASSERT_TRUE(game.ask(off));
  game.play(5);
  EXPECT_EQ(game.phase(), Phase::kInitial) << "nothing happens by itself";
  ASSERT_TRUE(game.ask(ControlGame::KICK_OFF, "blue"));
  ASSERT_TRUE(game.ask(ControlGame::SET));
  EXPECT_NEAR(game.poseOf("blue2").x, 0.35, 0.02);
  ASSERT_TRUE(game.ask(ControlGame::PLAY));
  game.place("ball", {2.25, 0.1, 0});
  game.play(1);
  EXPECT_EQ(game.run->game()->goals().at("red"), 0);
  robotcontrol::ControlGame score;
  score.set_action(ControlGame::SCORE);
  score.set_team("red");
  score.set_goals(3);
  ASSERT_TRUE(game.ask(score));
  EXPECT_EQ(game.run->game()->goals().at("red"), 3);
  ASSERT_TRUE(game.ask(ControlGame::PENALIZE, "blue1", "holding"));
  EXPECT_TRUE(game.referee().penaltyOf(2).has_value());
  ASSERT_TRUE(game.ask(ControlGame::RETURN, "blue1"));
  EXPECT_FALSE(game.referee().penaltyOf(2).has_value());
  ASSERT_TRUE(game.ask(ControlGame::FINISH));
  ASSERT_TRUE(game.ask(ControlGame::RESTART));
  EXPECT_EQ(game.run->game()->goals().at("red"), 0);
}

TEST(Referee, saysWhyItRefuses) {
  GameOf2002 game;
  EXPECT_EQ(game.ask(ControlGame::PENALIZE, "green7").error().id, "game.no-player");
  EXPECT_EQ(game.ask(ControlGame::PENALIZE, "red1", "laughing").error().id, "game.no-reason");
  EXPECT_EQ(game.ask(ControlGame::RETURN, "red1").error().id, "game.not-penalized");
  EXPECT_EQ(game.ask(ControlGame::KICK_OFF, "green").error().id, "game.no-team");
  EXPECT_EQ(game.ask(ControlGame::PENALIZE).error().id, "game.request");
  GameOf2002 practice(GameOf2002::options("field2002"));
  EXPECT_EQ(practice.run->referee(), nullptr);
  EXPECT_EQ(practice.ask(ControlGame::READY).error().id, "game.none");
}

TEST(Referee, rulesOfTheOptionsGoBeforeThoseOfTheScene) {
  RunOptions without = GameOf2002::options();
  without.game = kNoGame;
  EXPECT_EQ(GameOf2002(without).run->referee(), nullptr);
  RunOptions with = GameOf2002::options("field2002");
  with.game = "2002";
  EXPECT_NE(GameOf2002(with).run->referee(), nullptr);
  RunOptions unknown = GameOf2002::options();
  unknown.game = "1066";
  EXPECT_FALSE(SimulatedRun::create(unknown, {}));
}

TEST(Referee, aSnapshotKeepsTheGame) {
  GameOf2002 game;
  game.playUntil(Phase::kPlaying);
  game.place("ball", {2.25, 0.1, 0});
  game.run->step();
  ASSERT_TRUE(game.ask(ControlGame::PENALIZE, "blue2"));
  const simcore::Snapshot snapshot = game.run->snapshot();
  const auto left = game.referee().machine().left();
  ASSERT_TRUE(game.ask(ControlGame::RESTART));
  game.play(1);
  ASSERT_TRUE(game.run->restore(snapshot));
  EXPECT_EQ(game.run->game()->goals().at("red"), 1);
  EXPECT_EQ(game.phase(), Phase::kReady);
  EXPECT_EQ(game.referee().machine().left(), left);
  EXPECT_TRUE(game.referee().penaltyOf(3).has_value());
}

TEST(Referee, aSnapshotKeepsTheMessagesThatAreOnTheWay) {
  RunOptions options = GameOf2002::options();
  options.solutions["behavior"] = "soccer";
  GameOf2002 game(options);
  ControlGame radio;
  radio.set_action(ControlGame::RADIO);
  radio.mutable_radio()->set_delay(0.4);
  radio.mutable_radio()->set_loss(0.2);
  ASSERT_TRUE(game.ask(radio));
  game.play(2);
  const simcore::Snapshot snapshot = game.run->snapshot();
  ASSERT_GT(game.run->radio().sent(), 0U);
  const auto sent = game.run->radio().sent(), lost = game.run->radio().lost();
  game.play(1);
  EXPECT_GT(game.run->radio().sent(), sent);
  ASSERT_TRUE(game.run->restore(snapshot));
  EXPECT_EQ(game.run->radio().sent(), sent);
  EXPECT_EQ(game.run->radio().lost(), lost);
  EXPECT_EQ(game.run->snapshot().parts.at("radio"), snapshot.parts.at("radio"));
}

TEST(Referee, robotsAreToldTheGameAsAPackage) {
  std::vector<robotcontrol::GameState> heard;
  SimulatedRun::Listeners listeners;
  listeners.queue = [&](const std::string& robot, const auto& queue) {
    const auto wire = toWire(*queue);
    for (const auto& message : wire.messages()) {
      if (robot != "blue1" || message.path() != "game/state") continue;
      heard.emplace_back().ParseFromString(message.package().data());
    }
  };
  const auto run = makeRun(GameOf2002::options(), listeners);
  ASSERT_TRUE(run->request(keyRequest("blue1", "package/game/state")));
  play(*run, 6);
  ASSERT_GT(heard.size(), 20U);
  EXPECT_EQ(heard.back().robot(), "blue1");
  EXPECT_EQ(heard.back().team(), "blue");
  EXPECT_EQ(heard.back().number(), 1U);
  EXPECT_EQ(heard.back().role(), "goalie");
  EXPECT_EQ(heard.back().phase(), robotcontrol::GameState::PLAYING);
  ASSERT_EQ(heard.back().teams_size(), 2);
  EXPECT_EQ(heard.back().teams(1).attacks(), "yellow");
  EXPECT_FALSE(heard.back().penalized());
}

TEST(Referee, aGameIsTheSameForAnyNumberOfThreads) {
  const auto digest = [](int threads) {
    RunOptions options = simulationOptions(4);
    options.scene = sceneNamed("game2002-2");
    options.world.threads = threads;
    GameOf2002 game(options);
    game.play(5);
    return std::pair(game.run->world().digest(), game.texts);
  };
  const auto one = digest(1);
  EXPECT_EQ(digest(2), one);
  EXPECT_EQ(digest(3), one);
}

TEST(Referee, teamsHaveLayoutsAndSolutionsOfTheirOwn) {
  RunOptions options = simulationOptions();
  options.scene = sceneNamed("game2002-2");
  ASSERT_TRUE(chooseLayouts({"red=parallel"}, options));
  ASSERT_TRUE(chooseSolutions(
      {"blue/behavior=stand", "blue2/behavior=go-to-ball-and-kick", "camera-pose=kinematic"}, options));
  const auto run = makeRun(options);
  ASSERT_TRUE(run);
  EXPECT_EQ(run->layout().stem(), "parallel");
  EXPECT_EQ(run->otherLayouts().size(), 2U) << "blue1 and blue2";
  EXPECT_FALSE(chooseSolutions({"blue/=stand"}, options));
  EXPECT_FALSE(chooseSolutions({"stand"}, options));
  options.robotSolutions["red"]["behavior"] = "sleep";
  const auto wrong = SimulatedRun::create(options, {});
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().front().id, "solution.unknown");
}

TEST(Referee, aTeamGetsAnotherLayoutWhileTheOthersPlayOn) {
  RunOptions options = simulationOptions();
  options.scene = sceneNamed("game2002-2");
  const auto run = makeRun(options);
  ASSERT_TRUE(run);
  play(*run, 0.5);
  EXPECT_TRUE(run->setLayoutOf("blue", layoutNamed("parallel")).empty());
  EXPECT_EQ(run->layout().stem(), "soccer");
  EXPECT_EQ(run->otherLayouts().at("blue2").stem(), "parallel");
  EXPECT_TRUE(run->setLayoutOf("blue2", layoutNamed("soccer")).empty());
  EXPECT_EQ(run->otherLayouts().size(), 1U);
  EXPECT_FALSE(run->setLayoutOf("green", layoutNamed("soccer")).empty());
  EXPECT_FALSE(run->setLayoutOf("red", "/no/such/layout.yaml").empty());
  EXPECT_EQ(run->layout().stem(), "soccer");
  play(*run, 0.5);
  EXPECT_NEAR(robotlink::seconds(run->world().clock().now()), 1, 0.02);
  EXPECT_TRUE(run->setLayout(layoutNamed("balanced")).empty());
  EXPECT_EQ(run->layout().stem(), "balanced");
  EXPECT_TRUE(run->otherLayouts().empty()) << "it is chosen for all, also for the team that had another one";
}
