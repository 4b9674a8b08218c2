// SPDX-License-Identifier: GPL-3.0-or-later
// The players of the task behavior by their packages.
#include <gmock/gmock.h>

#include "BehaviorParameters.pb.h"
#include "robotcontrol/Game.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotcontrol/Motion.pb.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/packages/GamePackages.h"
#include "tests/modules/OneSolution.h"

namespace modules {
namespace {

using robotcontrol::MotionRequest;

OneSolution::Robot player(const char* name) {
  return {.map = nullptr, .name = name, .description = "ers210.yaml", .field = "2002.yaml"};
}

class SoccerSolutionTest : public testing::Test {
 protected:
  /// The robot is there in the field, and sees the ball half a meter ahead.
  void see(double x, double y, double heading) {
    robotcontrol::RobotPose pose;
    pose.mutable_robot_in_field()->set_x(x);
    pose.mutable_robot_in_field()->set_y(y);
    pose.mutable_robot_in_field()->set_heading(heading);
    soccer_.set(robotlink::kRobotPose, pose);
    robotcontrol::BallModel ball;
    ball.set_known(true);
    ball.mutable_position_in_robot()->set_x(0.5);
    ball.set_standard_deviation(0.1);
    soccer_.set(robotlink::kBallModel, ball);
  }
  std::string option(int depth) {
    const auto* state = soccer_.sent(robotlink::kBehaviorState);
    return state != nullptr && depth < state->active_size() ? state->active(depth).state() : "";
  }
  /// The kick that it requests with the ball before its paws.
  std::string kick() {
    auto& parameters = soccer_.parametersAs<robotcontrol::SoccerParameters>();
    parameters.set_kick("quick");
    parameters.set_far_clearance(0.5);
    robotcontrol::BallModel ball;
    ball.set_known(true);
    ball.mutable_position_in_robot()->set_x(0.13);
    for (int i = 0; i < 4; ++i) {
      see(1, 0, robotlink::kPi);
      soccer_.set(robotlink::kBallModel, ball);
      soccer_.execute();
      soccer_.pass(0.04);
    }
    return soccer_.sent(robotlink::kMotionRequest)->motion();
  }
  OneSolution soccer_{"behavior", "soccer", player("blue2")};
};

TEST_F(SoccerSolutionTest, itsOptionsAreSentWithReasonsAndTheirGraph) {
  see(1, 0, robotlink::kPi);
  soccer_.execute();
  soccer_.pass(1);
  soccer_.execute();
  const auto* state = soccer_.sent(robotlink::kBehaviorState);
  ASSERT_NE(state, nullptr);
  EXPECT_EQ(state->solution(), "soccer");
  ASSERT_EQ(state->active_size(), 3);
  EXPECT_EQ(state->active(1).option(), "playing");
  EXPECT_EQ(state->active(1).state(), "striker");
  EXPECT_EQ(state->active(1).seconds(), 1);
  EXPECT_FALSE(state->active(1).reason().empty());
  EXPECT_EQ(state->state(), "strike: " + option(2));
  const auto* graph = soccer_.sent(robotlink::kBehaviorGraph);
  ASSERT_NE(graph, nullptr);
  EXPECT_EQ(graph->options(0).name(), "game");
  for (const auto& known : graph->options())
    for (const auto& transition : known.transitions()) EXPECT_FALSE(transition.reason().empty());
  EXPECT_TRUE(soccer_.silentKeys().empty()) << *soccer_.silentKeys().begin();
}

TEST_F(SoccerSolutionTest, theTeamIsToldWhereBallAndRobotAre) {
  see(1, 0, robotlink::kPi);
  soccer_.execute();
  const auto* message = soccer_.sent(robotlink::kTeamMessage);
  ASSERT_NE(message, nullptr);
  EXPECT_EQ(message->sender(), "blue2");
  EXPECT_EQ(message->number(), 2U);
  EXPECT_EQ(message->role(), "striker");
  EXPECT_NEAR(message->ball_in_field().x(), 0.5, 1e-9);
  EXPECT_GT(message->seconds_to_ball(), 1);
  EXPECT_LT(message->seconds_to_ball(), 10);
}

TEST_F(SoccerSolutionTest, aMateThatIsFasterMakesItSupport) {
  see(1, 0, robotlink::kPi);
  robotcontrol::TeamMessages messages;
  auto& mate = *messages.add_messages();
  mate.set_sender("blue3");
  mate.set_team("blue");
  mate.set_number(3);
  mate.set_seconds_to_ball(0.2);
  mate.set_role("striker");
  mate.mutable_pose_in_field()->set_x(0.2);
  soccer_.set(robotlink::kTeamMessages, messages);
  soccer_.execute();
  EXPECT_EQ(option(1), "defender");
  soccer_.pass(10);
  see(1, 0, robotlink::kPi);
  soccer_.execute();
  EXPECT_EQ(option(1), "striker") << "who is heard no more counts no more";
}

TEST_F(SoccerSolutionTest, aBallThatAMateSeesIsBelievedInsteadOfAnOldOneOfItsOwn) {
  const auto secondsToBall = [&](double sinceMateSawIt) {
    soccer_.parametersAs<robotcontrol::SoccerParameters>().mutable_situation()->set_team_ball_after(0.7);
    see(1, 0, robotlink::kPi);
    robotcontrol::BallModel own;
    own.set_known(true);
    own.mutable_position_in_robot()->set_x(0.5);
    own.set_seconds_since_seen(1);
    soccer_.set(robotlink::kBallModel, own);
    robotcontrol::TeamBall ball;
    ball.set_known(true);
    ball.mutable_position_in_field()->set_x(-1.5);
    ball.add_seen_by("blue2");
    ball.add_seen_by("blue3");
    soccer_.set(robotlink::kTeamBall, ball);
    robotcontrol::TeamMessages messages;
    auto& mate = *messages.add_messages();
    mate.set_sender("blue3");
    mate.set_team("blue");
    mate.set_number(3);
    mate.set_ball_known(true);
    mate.set_seconds_since_ball_seen(sinceMateSawIt);
    mate.set_seconds_to_ball(100);
    soccer_.set(robotlink::kTeamMessages, messages);
    soccer_.execute();
    return soccer_.sent(robotlink::kTeamMessage)->seconds_to_ball();
  };
  const double own = secondsToBall(2);
  soccer_.pass(1);
  EXPECT_GT(secondsToBall(0.1), own + 5) << "it is 2 m farther away";
}

TEST_F(SoccerSolutionTest, theRefereeIsObeyedAndGoalsAreThoseThatItNames) {
  see(1, 0, robotlink::kPi);
  robotcontrol::GameState game;
  game.set_phase(robotcontrol::GameState::SET);
  game.set_number(2);
  soccer_.set(robotlink::kGameState, game);
  soccer_.execute();
  EXPECT_EQ(option(0), "set");
  game.set_phase(robotcontrol::GameState::PLAYING);
  game.set_penalized(true);
  soccer_.set(robotlink::kGameState, game);
  soccer_.execute();
  EXPECT_EQ(option(0), "penalized");
}

TEST_F(SoccerSolutionTest, aStateIsForcedByAParameter) {
  see(1, 0, robotlink::kPi);
  auto& control = *soccer_.parametersAs<robotcontrol::SoccerParameters>().mutable_control();
  control.set_forced("playing=goalie");
  soccer_.execute();
  EXPECT_EQ(option(1), "goalie");
  EXPECT_TRUE(soccer_.sent(robotlink::kBehaviorState)->active(1).forced());
  control.Clear();
  soccer_.execute();
  EXPECT_EQ(option(1), "striker");
}

TEST_F(SoccerSolutionTest, statesThatThereAreNotCannotBeForced) {
  const auto& check = robotlink::SolutionRegistry::find("behavior", "soccer")->parameterRules.check;
  robotcontrol::SoccerParameters parameters;
  EXPECT_EQ(check(parameters), "");
  parameters.mutable_control()->set_forced("game=play, playing=goalie");
  EXPECT_EQ(check(parameters), "");
  parameters.mutable_control()->set_forced("gam=play");
  EXPECT_THAT(check(parameters),
              testing::AllOf(testing::HasSubstr("'control.forced'"), testing::HasSubstr("no option 'gam'")));
}

TEST_F(SoccerSolutionTest, theFarKickIsPlayedIfTheParametersNameOne) {
  soccer_.parametersAs<robotcontrol::SoccerParameters>().set_far_kick("far");
  EXPECT_EQ(kick(), "far");
}

TEST_F(SoccerSolutionTest, withoutANameThereIsNoFarKick) {
  EXPECT_EQ(kick(), "quick");
}

TEST(PotentialFieldSolutionTest, walksToTheBallAndDrawsItsForces) {
  OneSolution field("behavior", "potential-field", player("red1"));
  robotcontrol::BallModel ball;
  ball.set_known(true);
  ball.mutable_position_in_robot()->set_x(0.8);
  field.set(robotlink::kBallModel, ball);
  field.execute();
  EXPECT_EQ(field.sent(robotlink::kMotionRequest)->kind(), MotionRequest::WALK);
  EXPECT_GT(field.sent(robotlink::kMotionRequest)->walk().x(), 0.05);
  EXPECT_EQ(field.sent(robotlink::kBehaviorState)->state(), "flow");
  EXPECT_TRUE(field.silentKeys().empty()) << *field.silentKeys().begin();
}

}  // namespace
}  // namespace modules
