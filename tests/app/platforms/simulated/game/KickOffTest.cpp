// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/game/KickOff.h"

#include <gmock/gmock.h>

#include "app/core/program/ShippedFiles.h"
#include "app/platforms/simulated/BallTrials.h"
#include "app/platforms/simulated/SimulatedRun.h"

using namespace app;
using robotlink::Pose2;
using testing::ElementsAre;
using testing::HasSubstr;

namespace {

/// A game on the field of 2002 that a test looks at.
struct Game {
  std::vector<std::string> texts;
  std::unique_ptr<SimulatedRun> run;

  explicit Game(RunOptions options = defaultSimulation()) {
    SimulatedRun::Listeners listeners;
    listeners.game = [this](robotlink::Instant, const std::string& text) { texts.push_back(text); };
    auto made = SimulatedRun::create(std::move(options), std::move(listeners));
    if (!made) throw std::runtime_error(robotlink::describe(made.error()));
    run = std::move(*made);
  }
  void place(const std::string& model, const Pose2& pose) {
    const auto placed = run->world().simulation().placeModel(model, pose);
    EXPECT_TRUE(placed) << placed.error().describe();
  }
  Pose2 poseOf(const std::string& model) const {
    return robotlink::groundPose(run->world().simulation().modelPose(model).value());
  }
  void play(double seconds) {
    const robotlink::Instant end = run->world().clock().now() + robotlink::fromSeconds(seconds);
    while (run->world().clock().now() < end) run->step();
  }
  /// Plays until something is so, but no longer than `seconds`.
  template <typename Condition>
  void playUntil(double seconds, Condition condition) {
    for (double played = 0; played < seconds && !condition(); played += 0.25) play(0.25);
  }
};

}  // namespace

TEST(KickOff, afterAGoalTheBallIsInTheMiddleAndTheRobotStartsAgain) {
  Game game;
  game.place("red1", {1.2, 0.6, 2});
  game.place("ball", {2.25, 0.1, 0});
  game.play(0.1);
  EXPECT_THAT(game.texts, ElementsAre("Goal for the red team! Red 1, blue 0."));
  game.play(1.7);
  EXPECT_GT(game.poseOf("ball").x, 2) << "for a moment it is seen where it is";
  game.play(0.3);
  EXPECT_THAT(game.texts, ElementsAre(HasSubstr("Goal"), HasSubstr("Kick-off")));
  EXPECT_NEAR(game.poseOf("ball").translation().norm(), 0, 0.01);
  EXPECT_NEAR(game.poseOf("red1").x, -0.8, 0.05);
  EXPECT_NEAR(game.poseOf("red1").y, 0, 0.05);
  EXPECT_NEAR(game.poseOf("red1").heading, 0, 0.1);
}

TEST(KickOff, aRobotScoresAndPlaysOn) {
  Game game;
  game.place("red1", {1.5, 0, 0});
  game.place("ball", {1.75, 0, 0});
  game.playUntil(25, [&] { return !game.texts.empty(); });
  ASSERT_FALSE(game.texts.empty());
  EXPECT_EQ(game.texts.front(), "Goal for the red team! Red 1, blue 0.");
  const auto touches = game.run->world().simulation().ballContacts();
  game.playUntil(25, [&] { return game.run->world().simulation().ballContacts() > touches; });
  EXPECT_GT(game.run->world().simulation().ballContacts(), touches) << "it comes to the ball again";
}

TEST(KickOff, eachGoalCountsForTheOtherTeamAndAResetForgetsThem) {
  Game game;
  game.place("ball", {-2.2, -0.2, 0});
  game.play(3);
  EXPECT_EQ(game.run->game()->goals(), (std::map<std::string, int>{{"blue", 1}, {"red", 0}}));
  ASSERT_TRUE(game.run->reset(1).empty());
  EXPECT_EQ(game.run->game()->goals(), (std::map<std::string, int>{{"blue", 0}, {"red", 0}}));
}

TEST(KickOff, aBallOnTheLineIsNoGoalAndOneBesideTheFieldComesBack) {
  Game game;
  game.place("ball", {2.11, 0, 0});
  game.play(0.1);
  EXPECT_TRUE(game.texts.empty());
  game.place("ball", {1, 1.8, 0});
  game.play(2.2);
  EXPECT_THAT(game.texts, ElementsAre("The ball left the field.", HasSubstr("Kick-off")));
  EXPECT_NEAR(game.poseOf("ball").translation().norm(), 0, 0.01);
  EXPECT_EQ(game.run->game()->goals().at("red"), 0);
}

TEST(KickOff, aBallThatAPersonBringsBackStaysWhereItIs) {
  Game game;
  game.place("red1", {-1.9, 1, 1.5});
  game.place("ball", {2.25, 0, 0});
  game.play(1);
  game.place("ball", {1.2, -1, 0});
  game.play(3);
  EXPECT_NEAR(game.poseOf("ball").x, 1.2, 0.02);
  EXPECT_THAT(game.texts, ElementsAre(HasSubstr("Goal")));
}

TEST(KickOff, aRobotInTheMiddleGoesToItsPlaceBeforeTheBallComes) {
  RunOptions options = defaultSimulation();
  options.solutions["behavior"] = "stand";
  Game game(options);
  game.place("ball", {2.25, 0, 0});
  game.play(1.9);
  game.place("red1", {0, 0, 0});
  game.play(0.5);
  EXPECT_NEAR(game.poseOf("red1").x, -0.8, 0.02);
  EXPECT_NEAR(game.poseOf("ball").translation().norm(), 0, 0.01);
}

TEST(KickOff, isTheSameEachTime) {
  const auto digest = [] {
    Game game;
    game.place("ball", {2.25, 0, 0});
    game.play(4);
    return game.run->world().digest();
  };
  EXPECT_EQ(digest(), digest());
}

TEST(KickOff, isOnlyWhereThereIsAFieldAndAGame) {
  RunOptions pioneer = defaultSimulation();
  pioneer.scene = sceneNamed("pioneer");
  EXPECT_EQ(Game(pioneer).run->game(), nullptr);
  RunOptions trial = defaultSimulation();
  trial.kickOffs = false;
  EXPECT_EQ(Game(trial).run->game(), nullptr);
}

TEST(AddedRobots, eightOfTwoTeamsStandAtTheirPlacesAndPlay) {
  RunOptions options = defaultSimulation();
  options.robots = simcore::RobotsToAdd{.model = "", .count = 7, .teams = teamsNamed("both")};
  Game game(options);
  EXPECT_THAT(game.run->robots(), testing::UnorderedElementsAre("red1", "red2", "red3", "red4", "blue1",
                                                                "blue2", "blue3", "blue4"));
  for (const std::string& robot : game.run->robots()) {
    const Pose2 pose = game.poseOf(robot);
    EXPECT_LT(pose.x * (robot.starts_with("red") ? 1 : -1), 0) << robot << " stands in its own half";
    EXPECT_LT(
        std::abs(robotlink::normalizedAngle(pose.heading - (robot.starts_with("red") ? 0 : robotlink::kPi))),
        1e-3);
  }
  const Pose2 red = game.poseOf("red3"), blue = game.poseOf("blue3");
  const auto way = [&](const char* robot, const Pose2& from) {
    return (game.poseOf(robot).translation() - from.translation()).norm();
  };
  game.playUntil(8, [&] { return way("red3", red) > 0.1 && way("blue3", blue) > 0.1; });
  EXPECT_GT(way("red3", red), 0.1);
  EXPECT_GT(way("blue3", blue), 0.1);
}

TEST(AddedRobots, allOfThemMayPlayInOneTeam) {
  RunOptions options = defaultSimulation();
  options.robots = simcore::RobotsToAdd{.model = "ers210", .count = 2, .teams = teamsNamed("blue")};
  Game game(options);
  EXPECT_THAT(game.run->robots(), ElementsAre("red1", "blue1", "blue2"));
}
