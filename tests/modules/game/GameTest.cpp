// SPDX-License-Identifier: GPL-3.0-or-later
// Whole games with the default solutions: what the robot does, as a spectator sees it.
#include <gmock/gmock.h>

#include "tests/modules/game/PlayedGame.h"

namespace modules {
namespace {

using robotlink::Vector2;

/// Plays until the ball is touched; true if that was within the time.
bool touches(PlayedGame& game, double seconds) {
  while (game.ballContacts() == 0 && game.time() < seconds) game.run(0.2);
  return game.ballContacts() > 0;
}

class Game : public testing::TestWithParam<Vector2> {};

TEST_P(Game, endsWithAKickedBall) {
  PlayedGame game;
  game.placeBall(GetParam());
  const Vector2 before = game.truth().robotInField * game.truth().ballInRobot;
  ASSERT_TRUE(touches(game, 60));
  game.run(2);
  const Vector2 after = game.truth().robotInField * game.truth().ballInRobot;
  EXPECT_GT((after - before).norm(), 0.1);
}

INSTANTIATE_TEST_SUITE_P(, Game, testing::Values(Vector2(0.4, 0.5), Vector2(-1.7, -0.6), Vector2(-1.2, 0.9)),
                         [](const auto& test) { return std::to_string(test.index); });

TEST(BlindGame, neverTouchesTheBallAndStaysWhereItIs) {
  PlayedGame game({}, {.blackout = true});
  game.placeBall({-0.4, 0});
  EXPECT_FALSE(touches(game, 30));
  EXPECT_LT(std::hypot(game.truth().robotInField.x + 0.8, game.truth().robotInField.y), 0.05);
}

TEST(GameTexts, sayWhatTheBehaviorDoesAndWhy) {
  PlayedGame game;
  game.placeBall({-0.1, 0.1});
  game.run(5);
  EXPECT_THAT(game.texts(), testing::Contains(testing::HasSubstr("approach: the ball is seen")));
}

TEST(GameWithOtherSolutions, touchesTheBallToo) {
  PlayedGame game(PlayedGame::Solutions{{"segmentation", "whole-image"},
                                        {"camera-pose", "fixed-stance"},
                                        {"ball-percept", "circle-fit"},
                                        {"landmark-percepts", "horizon-scan"},
                                        {"robot-percepts", "patch-clusters"},
                                        {"ball-model", "last-percept"},
                                        {"self-localisation", "odometry"}});
  game.placeBall({-0.1, 0.3});
  EXPECT_TRUE(touches(game, 40));
}

}  // namespace
}  // namespace modules
