// SPDX-License-Identifier: GPL-3.0-or-later
// What the robot believes, against what is true, while the whole program runs.
#include <gtest/gtest.h>

#include <cmath>

#include "robotcontrol/Modeling.pb.h"
#include "robotcontrol/Perception.pb.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/Packages.h"
#include "tests/modules/game/PlayedGame.h"

namespace modules {
namespace {

using robotlink::degrees;
using robotlink::Vector2;
using robotlink::Vector3;

/// Mean and largest of what was added.
struct Errors {
  double sum = 0, worst = 0;
  int count = 0;
  void add(double error) {
    sum += error;
    worst = std::max(worst, error);
    ++count;
  }
  double mean() const { return count > 0 ? sum / count : 0; }
};

class Accuracy : public testing::Test {
 protected:
  static void compareCamera(PlayedGame& game, Errors& place, Errors& direction) {
    game.watch<robotcontrol::CameraPose>(
        robotlink::kCameraPose.name, [&](const auto& pose, const auto& truth) {
          const robotlink::Pose3 found = robotlink::pose3(pose.camera_in_robot());
          place.add((found.translation() - truth.cameraInRobot.translation()).norm());
          const double cosine =
              (found.linear() * Vector3::UnitX()).dot(truth.cameraInRobot.linear() * Vector3::UnitX());
          direction.add(degrees(std::acos(std::min(1.0, cosine))));
        });
  }
};

class CameraPoseAccuracy : public Accuracy, public testing::WithParamInterface<const char*> {};

TEST_P(CameraPoseAccuracy, isACentimeterAndADegreeWhileStanding) {
  PlayedGame game(PlayedGame::Solutions{{"camera-pose", GetParam()}, {"behavior", "stand"}});
  Errors place, direction;
  game.run(1);  // to come to a stand
  compareCamera(game, place, direction);
  game.run(2);
  EXPECT_GT(place.count, 40);
  EXPECT_LT(place.worst, 0.01);
  EXPECT_LT(direction.worst, 1.5);
}

TEST_P(CameraPoseAccuracy, isUsableWhileWalking) {
  PlayedGame game(PlayedGame::Solutions{{"camera-pose", GetParam()}});
  Errors place, direction;
  compareCamera(game, place, direction);
  game.run(5);
  EXPECT_GT(place.count, 100);
  EXPECT_LT(place.mean(), 0.01);
  EXPECT_LT(direction.mean(), 2);
}

INSTANTIATE_TEST_SUITE_P(, CameraPoseAccuracy, testing::Values("kinematic", "fixed-stance", "oracle"),
                         [](const auto& test) {
                           const std::string name = test.param;
                           return name == "fixed-stance" ? "fixedStance" : name;
                         });

TEST_F(Accuracy, theOracleKnowsTheCamera) {
  PlayedGame game(PlayedGame::Solutions{{"camera-pose", "oracle"}, {"behavior", "stand"}});
  Errors place, direction;
  game.run(1);  // to come to a stand
  compareCamera(game, place, direction);
  game.run(2);
  EXPECT_GT(place.count, 40);
  EXPECT_LT(place.worst, 0.001);
  EXPECT_LT(direction.worst, 0.1);
}

class BallAccuracy : public Accuracy, public testing::WithParamInterface<const char*> {};

TEST_P(BallAccuracy, isGoodOnTheWayToTheBall) {
  PlayedGame game(PlayedGame::Solutions{{"ball-percept", GetParam()}});
  game.placeBall({0.2, 0.3});
  Errors percepts, models;
  int images = 0;
  game.watch<robotcontrol::BallPercept>(
      robotlink::kBallPercept.name, [&](const auto& ball, const auto& truth) {
        ++images;
        if (!ball.seen()) return;
        const Vector2 found = robotlink::vector2(ball.position_in_robot());
        percepts.add((found - truth.ballInRobot).norm() / truth.ballInRobot.norm());
      });
  game.watch<robotcontrol::BallModel>(robotlink::kBallModel.name, [&](const auto& ball, const auto& truth) {
    if (ball.known())
      models.add((robotlink::vector2(ball.position_in_robot()) - truth.ballInRobot).norm() /
                 truth.ballInRobot.norm());
  });
  game.run(6);
  EXPECT_GT(percepts.count, 0.9 * images);
  EXPECT_LT(percepts.mean(), 0.08);
  EXPECT_LT(models.mean(), 0.08);
}

INSTANTIATE_TEST_SUITE_P(, BallAccuracy, testing::Values("region", "circle-fit"), [](const auto& test) {
  return std::string(test.param) == "region" ? "region" : "circleFit";
});

using Localization = Accuracy;

TEST_F(Localization, findsItselfByLandmarksAndKnowsHowSureItIs) {
  PlayedGame game;
  game.placeBall({0.2, 0.9});
  game.run(3);
  Errors place, heading, believed;
  game.watch<robotcontrol::RobotPose>(robotlink::kRobotPose.name, [&](const auto& pose, const auto& truth) {
    const robotlink::Pose2 found = robotlink::pose2(pose.robot_in_field());
    place.add((found.translation() - truth.robotInField.translation()).norm());
    heading.add(degrees(std::abs(robotlink::normalizedAngle(found.heading - truth.robotInField.heading))));
    believed.add(pose.position_deviation());
  });
  game.run(9);
  EXPECT_GT(place.count, 200);
  EXPECT_LT(place.mean(), 0.3);
  EXPECT_LT(heading.mean(), 10);
  EXPECT_LT(place.mean(), 4 * believed.mean());
}

TEST_F(Localization, ofTheOracleIsExact) {
  PlayedGame game(PlayedGame::Solutions{{"self-localisation", "oracle"}, {"ball-model", "oracle"}});
  Errors place, ball;
  game.watch<robotcontrol::RobotPose>(robotlink::kRobotPose.name, [&](const auto& pose, const auto& truth) {
    place.add(
        (robotlink::pose2(pose.robot_in_field()).translation() - truth.robotInField.translation()).norm());
  });
  game.watch<robotcontrol::BallModel>(robotlink::kBallModel.name, [&](const auto& model, const auto& truth) {
    ball.add((robotlink::vector2(model.position_in_robot()) - truth.ballInRobot).norm());
  });
  game.run(2);
  EXPECT_GT(place.count, 40);
  EXPECT_LT(place.worst, 0.002);
  EXPECT_LT(ball.worst, 0.005);
}

}  // namespace
}  // namespace modules
