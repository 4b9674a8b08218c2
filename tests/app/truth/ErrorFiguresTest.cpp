// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/truth/ErrorFigures.h"

#include <gmock/gmock.h>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Perception.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/truth/TruthErrors.h"

namespace app {
namespace {

using robotlink::Instant;

/// A robot in the middle of the field that sees the ball 1 m before its feet, or does not, at a second.
void addBallFrame(robotlink::TruthErrors& errors, int second, bool isSeen) {
  const Instant time{std::chrono::seconds(second)};
  auto percept = std::make_shared<robotcontrol::BallPercept>();
  robotlink::assign(*percept->mutable_timestamp(), time);
  percept->set_seen(isSeen);
  robotlink::assign(*percept->mutable_position_in_robot(), robotlink::Vector2(1.1, 0));
  errors.add("red1", "percepts/ball", time, percept);
  auto truth = std::make_shared<robotcontrol::OracleWorld>();
  robotlink::assign(*truth->mutable_timestamp(), time);
  robotlink::assign(*truth->mutable_robot_in_field(), robotlink::Pose2{});
  robotlink::assign(*truth->mutable_ball_in_field(), robotlink::Vector3(1, 0, 0.04));
  auto& camera = *truth->mutable_camera();
  robotlink::Pose3 pose = robotlink::Pose3::Identity();
  pose.translation() = robotlink::Vector3(0.1, 0, 0.2);
  robotlink::assign(*camera.mutable_camera_in_robot(), pose);
  camera.set_horizontal_angle(1);
  camera.set_vertical_angle(0.8);
  errors.add("red1", "oracle/world", time, truth);
}

void addBallSolution(robotlink::TruthErrors& errors, int second, const char* active) {
  auto table = std::make_shared<robotcontrol::SolutionTable>();
  auto& task = *table->add_tasks();
  task.set_active(active);
  auto& solution = *task.add_solutions();
  solution.set_name(active);
  solution.add_outputs("percepts/ball");
  errors.add("red1", "tables/solutions", Instant{std::chrono::seconds(second)}, table);
}

TEST(ErrorFigures, figuresHaveUnitsAndSharesOnlyOfWhatThereWas) {
  robotlink::TruthErrors errors;
  addBallFrame(errors, 1, false);
  const auto figures = errorFigures(errors);
  EXPECT_EQ(figures["red1"]["percepts/ball"]["missed"], 1.0);
  EXPECT_FALSE(figures["red1"]["percepts/ball"].contains("false")) << "nothing was reported";
  EXPECT_THAT(errorsText(figures), testing::HasSubstr("median"));
  EXPECT_EQ(errorsText(nlohmann::json::object()), "");
}

TEST(ErrorFigures, whatHappensToTheBodyHasSharesOfTimeAndItsOwnCounts) {
  robotlink::TruthErrors errors;
  for (int i = 0; i < 100; ++i) {
    const Instant time{std::chrono::milliseconds(40 * i)};
    auto truth = std::make_shared<robotcontrol::RobotState>(),
         state = std::make_shared<robotcontrol::RobotState>();
    robotlink::assign(*truth->mutable_timestamp(), time);
    robotlink::assign(*state->mutable_timestamp(), time);
    truth->set_picked_up(i >= 25);
    state->set_picked_up(i >= 30);
    errors.add("red1", "percepts/robot-state", time, state);
    errors.add("red1", "oracle/state", time, truth);
  }
  const auto figures = errorFigures(errors);
  const auto& lifted = figures["red1"]["percepts/robot-state"]["picked up"];
  EXPECT_NEAR(lifted.at("mean").get<double>(), 0.05, 1e-9);
  EXPECT_FALSE(lifted.contains("median")) << "a share of time has none";
  EXPECT_EQ(lifted.at("missed"), 0.0);
  EXPECT_EQ(lifted.at("there"), 1);
  EXPECT_NEAR(figures["red1"]["percepts/robot-state"]["picked up delay"]["mean"].get<double>(), 0.2, 1e-9);
  EXPECT_THAT(errorsText(figures), testing::ContainsRegex("picked up +5.0 % +- +- +0.0 % +0.0 %"));
}

TEST(ErrorFigures, solutionsAreNamedWhereSeveralHavePublishedAStream) {
  robotlink::TruthErrors errors;
  addBallSolution(errors, 1, "scan-lines");
  addBallFrame(errors, 1, true);
  EXPECT_TRUE(errorFigures(errors)["red1"].contains("percepts/ball"));
  addBallSolution(errors, 2, "oracle");
  addBallFrame(errors, 2, false);
  const auto figures = errorFigures(errors)["red1"];
  EXPECT_EQ(figures.size(), 2U);
  EXPECT_EQ(figures["percepts/ball (scan-lines)"]["position"]["count"], 1);
  EXPECT_EQ(figures["percepts/ball (oracle)"]["missed"], 1.0);
}

}  // namespace
}  // namespace app
