// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/truth/TruthErrors.h"

#include <gmock/gmock.h>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Game.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotcontrol/Perception.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/packages/Conversions.h"

namespace robotlink {
namespace {

constexpr Duration kTruthFrame = std::chrono::milliseconds(40);

class TruthErrorsTest : public testing::Test {
 protected:
  /// The robot stands at (1, 0) and looks along +y; the ball lies 1 m in front of it.
  void tellTruth(Instant time) {
    auto truth = std::make_shared<robotcontrol::OracleWorld>();
    assign(*truth->mutable_timestamp(), time);
    assign(*truth->mutable_robot_in_field(), Pose2{1, 0, kPi / 2});
    assign(*truth->mutable_ball_in_field(), Vector3(1, 1, 0.04));
    auto& other = *truth->add_others();
    other.set_name("blue1");
    assign(*other.mutable_pose_in_field(), Pose2{1, 1.5, 0});
    auto& camera = *truth->mutable_camera();
    Pose3 pose = Pose3::Identity();
    pose.translation() = Vector3(0.1, 0, 0.2);
    assign(*camera.mutable_camera_in_robot(), pose);
    camera.set_horizontal_angle(1);
    camera.set_vertical_angle(0.8);
    errors_.add("red1", "oracle/world", time, truth);
  }
  template <typename T>
  std::shared_ptr<T> at(Instant time) {
    auto value = std::make_shared<T>();
    assign(*value->mutable_timestamp(), time);
    return value;
  }
  void ballPercept(Instant time, const std::optional<Vector2>& place) {
    auto percept = at<robotcontrol::BallPercept>(time);
    percept->set_seen(place.has_value());
    if (place) assign(*percept->mutable_position_in_robot(), *place);
    errors_.add("red1", "percepts/ball", time + kTruthFrame, percept);
  }
  const PackageErrors& of(const std::string& path, const std::string& solution = {}) {
    return errors_.errors().at("red1").at({path, solution});
  }

  TruthErrors errors_;
};

TEST_F(TruthErrorsTest, aBallIsComparedInTheFrameOfTheRobot) {
  const Instant time(std::chrono::seconds(1));
  tellTruth(time);
  auto model = at<robotcontrol::BallModel>(time);
  model->set_known(true);
  assign(*model->mutable_position_in_robot(), Vector2(1, 0.1));
  errors_.add("red1", "models/ball", time + kTruthFrame, model);
  tellTruth(time + kTruthFrame);
  EXPECT_NEAR(of("models/ball").quantities.at("position").amounts.mean(), 0.1, 1e-9);
  EXPECT_NEAR(of("models/ball").quantities.at("relative").amounts.mean(), 0.1, 1e-9);
  EXPECT_NEAR(of("models/ball").latency.mean(), 0.04, 1e-9);
}

TEST_F(TruthErrorsTest, theBallOfATeamIsComparedInTheField) {
  const Instant time(std::chrono::seconds(1));
  tellTruth(time);
  auto ball = at<robotcontrol::TeamBall>(time);
  errors_.add("red1", "models/team-ball", time, ball);
  auto known = at<robotcontrol::TeamBall>(time);
  known->set_known(true);
  assign(*known->mutable_position_in_field(), Vector2(1.2, 1));
  errors_.add("red1", "models/team-ball", time, known);
  tellTruth(time + kTruthFrame);
  EXPECT_EQ(of("models/team-ball").there, 2U);
  EXPECT_EQ(of("models/team-ball").missed, 1U);
  EXPECT_EQ(of("models/team-ball").reported, 1U);
  EXPECT_NEAR(of("models/team-ball").quantities.at("position").amounts.mean(), 0.2, 1e-9);
}

TEST_F(TruthErrorsTest, whileARobotIsPenalizedNothingIsCompared) {
  const Instant start(std::chrono::seconds(1));
  const auto frame = [&](int number, bool isPenalized) {
    const Instant time = start + number * kTruthFrame;
    auto game = at<robotcontrol::GameState>(time);
    game->set_penalized(isPenalized);
    errors_.add("red1", "game/state", time, game);
    auto pose = at<robotcontrol::RobotPose>(time);
    assign(*pose->mutable_robot_in_field(), isPenalized ? Pose2{9, 9, 0} : Pose2{1, 0, 0});
    errors_.add("red1", "models/pose", time, pose);
    tellTruth(time);
  };
  frame(0, false);
  for (int i = 1; i < 4; ++i) frame(i, true);
  frame(4, false);
  frame(5, true);
  frame(6, false);
  EXPECT_EQ(of("models/pose").quantities.at("position").amounts.count(), 3U);
  EXPECT_NEAR(of("models/pose").quantities.at("position").amounts.maximum(), 0, 1e-9);
}

TEST_F(TruthErrorsTest, aGameStateWithoutTimeDecidesNothing) {
  const Instant time(std::chrono::seconds(1));
  auto game = std::make_shared<robotcontrol::GameState>();
  game->set_penalized(true);
  errors_.add("red1", "game/state", time, game);
  errors_.add("red1", "models/pose", time, at<robotcontrol::RobotPose>(time));
  tellTruth(time);
  EXPECT_EQ(of("models/pose").latency.count(), 1U);
}

TEST_F(TruthErrorsTest, theStateOfTheBodyIsComparedWithItsOwnTruth) {
  Instant time(std::chrono::seconds(1));
  const auto pass = [&](int ms, bool isDown, bool isReported) {
    for (const Instant end = time + std::chrono::milliseconds(ms); time < end; time += kTruthFrame) {
      auto truth = at<robotcontrol::RobotState>(time), state = at<robotcontrol::RobotState>(time);
      truth->set_fallen(isDown);
      truth->set_side(isDown ? robotcontrol::RobotState::ON_LEFT : robotcontrol::RobotState::UPRIGHT);
      truth->add_collisions("hind left");
      state->set_fallen(isReported);
      state->set_side(isReported ? robotcontrol::RobotState::ON_BACK : robotcontrol::RobotState::UPRIGHT);
      errors_.add("red1", "percepts/robot-state", time, state);
      errors_.add("red1", "oracle/state", time, truth);
    }
  };
  pass(1000, false, false);
  pass(400, true, false);
  pass(3600, true, true);
  const PackageErrors& state = of("percepts/robot-state");
  const ErrorQuantity& fallen = state.quantities.at("fallen");
  EXPECT_EQ(fallen.unit, kShareOfTime);
  EXPECT_NEAR(fallen.amounts.mean(), 0.08, 1e-9);
  EXPECT_EQ(fallen.own.there, 1U);
  EXPECT_EQ(fallen.own.missed, 0U);
  EXPECT_NEAR(state.quantities.at("fallen delay").amounts.mean(), 0.4, 1e-9);
  EXPECT_NEAR(state.quantities.at("side").amounts.mean(), 1, 1e-9);
  EXPECT_EQ(state.quantities.at("picked up").amounts.maximum(), 0);
  EXPECT_NEAR(state.quantities.at("collided").amounts.mean(), 0.25, 1e-9) << "one of four legs";
  EXPECT_EQ(state.quantities.at("collided").own.missed, 1U);
}

TEST_F(TruthErrorsTest, whatComesBeforeItsTruthWaitsForIt) {
  const Instant time(std::chrono::seconds(1));
  auto pose = at<robotcontrol::RobotPose>(time);
  assign(*pose->mutable_robot_in_field(), Pose2{1.3, 0.4, kPi / 2 - 0.2});
  errors_.add("red1", "models/pose", time, pose);
  EXPECT_TRUE(errors_.errors().empty());
  tellTruth(time);
  EXPECT_NEAR(of("models/pose").quantities.at("position").amounts.mean(), 0.5, 1e-9);
  EXPECT_NEAR(of("models/pose").quantities.at("heading").amounts.mean(), 0.2, 1e-9);
}

TEST_F(TruthErrorsTest, whatIsInTheImageAndNotSeenIsMissed) {
  const Instant time(std::chrono::seconds(1));
  ballPercept(time, std::nullopt);
  ballPercept(time, Vector2(1.05, 0));
  ballPercept(time, Vector2(2.5, 0));
  tellTruth(time);
  const PackageErrors& ball = of("percepts/ball");
  EXPECT_EQ(ball.there, 3U);
  EXPECT_EQ(ball.missed, 1U);
  EXPECT_EQ(ball.reported, 2U);
  EXPECT_EQ(ball.invented, 1U) << "1.5 m beside the ball is no error of a percept of the ball";
  EXPECT_NEAR(ball.quantities.at("position").amounts.maximum(), 0.05, 1e-9);
}

TEST_F(TruthErrorsTest, robotsAreMatchedWithTheNearestOnes) {
  const Instant time(std::chrono::seconds(1));
  auto percepts = at<robotcontrol::RobotPercepts>(time);
  assign(*percepts->add_robots()->mutable_position_in_robot(), Vector2(1.4, 0));
  assign(*percepts->add_robots()->mutable_position_in_robot(), Vector2(1.6, 0));
  errors_.add("red1", "percepts/robots", time, percepts);
  tellTruth(time);
  EXPECT_EQ(of("percepts/robots").missed, 0U);
  EXPECT_EQ(of("percepts/robots").invented, 1U) << "one robot cannot be seen twice";
}

TEST_F(TruthErrorsTest, landmarksAreThoseOfTheField) {
  auto field = std::make_shared<FieldDescription>();
  field->goals.push_back({"skyblue", 1, "skyblue"});
  field->beacons.push_back({"post", {1, 2}, "", ""});
  errors_.setField(field);
  const Instant time(std::chrono::seconds(1));
  auto percepts = at<robotcontrol::LandmarkPercepts>(time);
  auto& post = *percepts->add_landmarks();
  post.set_name("post");
  post.set_distance(2.2);
  post.set_bearing(0.05);
  percepts->add_landmarks()->set_name("moon");
  errors_.add("red1", "percepts/landmarks", time, percepts);
  tellTruth(time);
  const PackageErrors& landmarks = of("percepts/landmarks");
  EXPECT_NEAR(landmarks.quantities.at("distance").amounts.mean(), 0.2, 1e-9);
  EXPECT_NEAR(landmarks.quantities.at("bearing").amounts.mean(), 0.05, 1e-9);
  EXPECT_EQ(landmarks.invented, 1U);
  EXPECT_EQ(landmarks.there, 1U) << "the goal is behind the robot's feet";
}

TEST_F(TruthErrorsTest, aShadowHasErrorsOfItsOwn) {
  const Instant time(std::chrono::seconds(1));
  auto pose = at<robotcontrol::RobotPose>(time);
  errors_.add("red1", "shadow/odometry/models/pose", time, pose);
  tellTruth(time);
  EXPECT_EQ(errors_.errors().at("red1").count({"models/pose", ""}), 0U);
  EXPECT_NEAR(of("shadow/odometry/models/pose", "odometry").quantities.at("position").amounts.mean(), 1,
              1e-9);
}

TEST_F(TruthErrorsTest, otherStreamsAndMessagesWithoutATimeAreSkipped) {
  const Instant time(std::chrono::seconds(1));
  errors_.add("red1", "models/ball", time, std::make_shared<robotcontrol::BallModel>());
  errors_.add("red1", "camera/image", time, at<robotcontrol::BallModel>(time));
  errors_.add("red1", "shadow", time, at<robotcontrol::BallModel>(time));
  errors_.add("red1", "shadow/", time, at<robotcontrol::BallModel>(time));
  errors_.add("red1", "models/pose", time, at<robotcontrol::BallModel>(time));
  tellTruth(time);
  EXPECT_TRUE(of("models/pose").quantities.empty()) << "it is of another type";
  EXPECT_EQ(errors_.errors().at("red1").size(), 1U);
}

TEST_F(TruthErrorsTest, solutionsThatAreSwitchedAreKeptApart) {
  const Instant start(std::chrono::seconds(1));
  const auto solutions = [&](const char* path, Instant time, const char* active) {
    auto table = std::make_shared<robotcontrol::SolutionTable>();
    auto& task = *table->add_tasks();
    task.set_name("ball-model");
    task.set_active(active);
    for (const char* name : {"kalman", "particles"}) {
      auto& solution = *task.add_solutions();
      solution.set_name(name);
      solution.add_outputs("models/ball");
    }
    errors_.add("red1", path, time, table);
  };
  const auto frame = [&](int number, double x) {
    auto model = at<robotcontrol::BallModel>(start + number * kTruthFrame);
    model->set_known(true);
    assign(*model->mutable_position_in_robot(), Vector2(x, 0));
    errors_.add("red1", "models/ball", start + number * kTruthFrame, model);
  };
  solutions("tables/solutions/cognition", start, "kalman");
  frame(0, 1.1);
  tellTruth(start);
  frame(1, 1.1);
  frame(2, 1.3);
  solutions("tables/solutions/cognition", start + 2 * kTruthFrame, "particles");
  solutions("tables/solutions", start + 3 * kTruthFrame, "particles");
  tellTruth(start + kTruthFrame);
  tellTruth(start + 2 * kTruthFrame);
  const auto& errors = errors_.errors().at("red1");
  ASSERT_EQ(errors.size(), 2U);
  const auto& kalman = errors.at({"models/ball", "kalman"}).quantities.at("position").amounts;
  EXPECT_EQ(kalman.count(), 2U);
  EXPECT_NEAR(kalman.mean(), 0.1, 1e-9);
  const auto& particles = errors.at({"models/ball", "particles"}).quantities.at("position").amounts;
  EXPECT_EQ(particles.count(), 1U) << "what the frame of the switch has published is its own";
  EXPECT_NEAR(particles.last(), 0.3, 1e-9);
  errors_.clearErrors();
  frame(3, 1.2);
  tellTruth(start + 3 * kTruthFrame);
  EXPECT_NEAR(of("models/ball", "particles").quantities.at("position").amounts.mean(), 0.2, 1e-9);
}

}  // namespace
}  // namespace robotlink
