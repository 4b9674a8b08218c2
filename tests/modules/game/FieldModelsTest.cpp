// SPDX-License-Identifier: GPL-3.0-or-later
// The models of the field against what is true, while the whole program plays.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "robotcontrol/Game.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotcontrol/Perception.pb.h"
#include "robotlink/base/Random.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/GamePackages.h"
#include "tests/modules/game/PlayedGame.h"

namespace modules {
namespace {

using robotlink::Pose2;
using robotlink::Vector2;

/// The mean of errors and how many there were.
class MeanError {
 public:
  void add(double error) {
    sum_ += error;
    ++count_;
  }
  double mean() const { return count_ > 0 ? sum_ / count_ : 0; }
  int count() const { return count_; }

 private:
  double sum_ = 0;
  int count_ = 0;
};

class FieldLocalizer : public testing::TestWithParam<const char*> {
 protected:
  static PlayedGame::Solutions solutions() { return {{"self-localisation", GetParam()}}; }
};

TEST_P(FieldLocalizer, isGoodWhilePlaying) {
  PlayedGame game(solutions());
  game.placeBall({0.2, 0.9});
  game.run(4);
  MeanError place, heading;
  game.watch<robotcontrol::RobotPose>(robotlink::kRobotPose.name, [&](const auto& pose, const auto& truth) {
    const Pose2 found = robotlink::pose2(pose.robot_in_field());
    place.add((found.translation() - truth.robotInField.translation()).norm());
    heading.add(std::abs(robotlink::normalizedAngle(found.heading - truth.robotInField.heading)));
  });
  game.run(10);
  EXPECT_GT(place.count(), 200);
  // Without particles that start over, the filter takes longer where few landmarks are seen, and suffers more
  // from the odometry of the gait of games, which drifts while the robot turns.
  const bool isKalman = GetParam() == std::string("kalman");
  EXPECT_LT(place.mean(), isKalman ? 0.8 : 0.15);
  EXPECT_LT(heading.mean(), robotlink::radians(isKalman ? 12 : 8));
}

TEST_P(FieldLocalizer, saysSomethingUnderEachOfItsKeys) {
  PlayedGame game(solutions());
  std::set<std::string> keys;
  for (const int key : robotlink::SolutionRegistry::find("self-localisation", GetParam())->keys)
    keys.insert(robotlink::DebugKey::all()[static_cast<std::size_t>(key)].name);
  for (const std::string& key : keys) game.publish(key);
  game.run(1.5);
  for (const std::string& key : keys) {
    EXPECT_TRUE(std::ranges::any_of(game.paths(), [&](const std::string& path) {
      return path.find("/" + key) != std::string::npos;
    })) << key;
  }
}

INSTANTIATE_TEST_SUITE_P(All, FieldLocalizer, testing::Values("field-monte-carlo", "kalman"),
                         [](const auto& test) {
                           return std::string(test.param) == "kalman" ? "kalman" : "fieldMonteCarlo";
                         });

class BallTrackerGame : public testing::TestWithParam<const char*> {};

TEST_P(BallTrackerGame, isGoodOnTheWayToTheBall) {
  PlayedGame game(PlayedGame::Solutions{{"ball-model", GetParam()}});
  game.placeBall({0.2, 0.3});
  MeanError models;
  game.watch<robotcontrol::BallModel>(robotlink::kBallModel.name, [&](const auto& ball, const auto& truth) {
    if (ball.known() && truth.ballInRobot.norm() < 1.5)
      models.add((robotlink::vector2(ball.position_in_robot()) - truth.ballInRobot).norm() /
                 truth.ballInRobot.norm());
  });
  game.run(6);
  EXPECT_GT(models.count(), 100);
  EXPECT_LT(models.mean(), 0.1);
}

INSTANTIATE_TEST_SUITE_P(All, BallTrackerGame, testing::Values("kalman", "particle"),
                         [](const auto& test) { return std::string(test.param); });

class RobotStateGame : public testing::TestWithParam<const char*> {};

TEST_P(RobotStateGame, noticesThatTheRobotIsInTheAirAndNothingWhileItWalks) {
  PlayedGame game(PlayedGame::Solutions{{"robot-state", GetParam()}});
  game.placeBall({1.6, 0.3});
  int states = 0, wrong = 0;
  bool pickedUp = false;
  game.watch<robotcontrol::RobotState>(robotlink::kRobotState.name, [&](const auto& state, const auto&) {
    ++states;
    wrong += state.fallen() || state.picked_up() ? 1 : 0;
    pickedUp = state.picked_up();
  });
  game.run(4);
  EXPECT_GT(states, 300);
  EXPECT_LT(wrong, 0.02 * states);
}

INSTANTIATE_TEST_SUITE_P(All, RobotStateGame, testing::Values("contacts", "joint-errors"),
                         [](const auto& test) {
                           return std::string(test.param) == "contacts" ? "contacts" : "jointErrors";
                         });

}  // namespace
}  // namespace modules
