// SPDX-License-Identifier: GPL-3.0-or-later
// The team's ball by its packages: what a robot knows itself, and what its team says.
#include <gtest/gtest.h>

#include "robotcontrol/Game.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/GamePackages.h"
#include "tests/modules/OneSolution.h"

namespace modules {
namespace {

const OneSolution::Robot kAibo{.map = nullptr, .name = "red1", .description = "ers210.yaml"};

class TeamBallSolution : public testing::TestWithParam<const char*> {
 protected:
  /// The robot stands at (1, 0), looks along y, and knows the ball before it, or not.
  void model(bool known, double deviation = 0.1) {
    robotcontrol::BallModel ball;
    robotlink::assign(*ball.mutable_timestamp(), solution_.clock().now());
    ball.set_known(known);
    ball.mutable_position_in_robot()->set_x(0.5);
    ball.mutable_velocity_in_robot()->set_x(0.2);
    ball.set_standard_deviation(deviation);
    robotcontrol::RobotPose pose;
    *pose.mutable_timestamp() = ball.timestamp();
    robotlink::assign(*pose.mutable_robot_in_field(), robotlink::Pose2{1, 0, robotlink::kPi / 2});
    pose.set_position_deviation(0.05);
    solution_.set(robotlink::kBallModel, ball);
    solution_.set(robotlink::kRobotPose, pose);
  }
  /// Another robot knows the ball at a place of the field.
  void hear(double x, double y, double deviation) {
    robotcontrol::TeamMessages team;
    robotcontrol::TeamMessage& message = *team.add_messages();
    robotlink::assign(*message.mutable_timestamp(), solution_.clock().now());
    message.set_sender("red2");
    message.set_ball_known(true);
    message.mutable_ball_in_field()->set_x(x);
    message.mutable_ball_in_field()->set_y(y);
    message.set_ball_deviation(deviation);
    solution_.set(robotlink::kTeamMessages, team);
  }
  const robotcontrol::TeamBall& ball() {
    solution_.execute();
    return *solution_.sent(robotlink::kTeamBall);
  }
  OneSolution solution_{"team-ball", GetParam(), kAibo};
};

TEST_P(TeamBallSolution, knowsWhatTheRobotKnowsInTheField) {
  model(true);
  const robotcontrol::TeamBall& team = ball();
  ASSERT_TRUE(team.known());
  EXPECT_NEAR(team.position_in_field().x(), 1, 1e-9);
  EXPECT_NEAR(team.position_in_field().y(), 0.5, 1e-9);
  EXPECT_NEAR(team.velocity_in_field().y(), 0.2, 1e-9);
  EXPECT_GT(team.standard_deviation(), 0.1);
  ASSERT_EQ(team.seen_by_size(), 1);
  EXPECT_EQ(team.seen_by(0), "red1");
}

TEST_P(TeamBallSolution, isUnknownIfNobodyKnowsTheBall) {
  model(false);
  EXPECT_FALSE(ball().known());
}

TEST_P(TeamBallSolution, saysSomethingUnderEachOfItsKeys) {
  model(true);
  ball();
  EXPECT_EQ(solution_.silentKeys(), std::set<std::string>());
}

INSTANTIATE_TEST_SUITE_P(All, TeamBallSolution, testing::Values("own", "weighted"),
                         [](const auto& test) { return std::string(test.param); });

class WeightedTeamBall : public TeamBallSolution {};

TEST_P(WeightedTeamBall, knowsTheBallThatOnlyAnotherRobotSees) {
  model(false);
  hear(-1, 0.3, 0.1);
  const robotcontrol::TeamBall& team = ball();
  ASSERT_TRUE(team.known());
  EXPECT_NEAR(team.position_in_field().x(), -1, 1e-9);
  EXPECT_EQ(team.seen_by(0), "red2");
}

TEST_P(WeightedTeamBall, believesTheMoreCertainRobot) {
  model(true, 0.5);
  hear(1.2, 0.4, 0.05);
  EXPECT_NEAR(ball().position_in_field().x(), 1.2, 0.05);
}

TEST_P(WeightedTeamBall, forgetsWhatIsOld) {
  hear(-1, 0.3, 0.1);
  model(false);
  EXPECT_TRUE(ball().known());
  solution_.pass(20);
  model(false);
  EXPECT_FALSE(ball().known());
}

INSTANTIATE_TEST_SUITE_P(All, WeightedTeamBall, testing::Values("weighted"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace modules
