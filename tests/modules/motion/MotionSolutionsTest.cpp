// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "MotionParameters.pb.h"
#include "foxglove/Robot.pb.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotcontrol/Motion.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "tests/modules/OneSolution.h"

namespace modules {
namespace {

/// A solution of a dog's program, 8 ms a frame.
class DogSolution : public OneSolution {
 public:
  DogSolution(const std::string& task, const std::string& name)
      : OneSolution(task, name, {nullptr, "red1", "ers210.yaml", false}) {}
  void run(int frames) {
    for (int i = 0; i < frames; ++i) {
      pass(0.008);
      execute();
    }
  }
};

foxglove::JointStates jointsAtStance(const robotlink::RobotDescription& robot) {
  foxglove::JointStates states;
  for (const auto& joint : robot.joints) {
    auto& state = *states.add_joints();
    state.set_name(joint.name);
    state.set_position(joint.stance);
  }
  return states;
}

robotcontrol::BodySensors upright() {
  robotcontrol::BodySensors sensors;
  sensors.mutable_acceleration()->set_z(9.81);
  return sensors;
}

robotcontrol::MotionRequest walking(double x) {
  robotcontrol::MotionRequest request;
  request.set_kind(robotcontrol::MotionRequest::WALK);
  request.mutable_walk()->set_x(x);
  return request;
}

class MotionSolutionTest : public testing::TestWithParam<const char*> {
 protected:
  MotionSolutionTest() : motion_("motion", GetParam()) {
    motion_.set(robotlink::kJointStates, jointsAtStance(motion_.robot().description));
    motion_.set(robotlink::kBodySensors, upright());
  }
  DogSolution motion_;
};

TEST_P(MotionSolutionTest, aWalkMovesTheLegsAndIsTold) {
  motion_.set(robotlink::kMotionRequest, walking(0.1));
  motion_.run(200);
  const auto& joints = *motion_.sent(robotlink::kJointRequest);
  ASSERT_EQ(joints.positions_size(), static_cast<int>(motion_.robot().description.joints.size()));
  EXPECT_EQ(joints.stiffness(), 1);
  const auto& status = *motion_.sent(robotlink::kMotionStatus);
  EXPECT_EQ(status.executed().kind(), robotcontrol::MotionRequest::WALK);
  EXPECT_NEAR(status.velocity().x(), 0.1, 1e-9);
  EXPECT_NEAR(status.odometry().x(), 0.1 * (1.6 - 0.5) - 0.0125, 0.01);
  EXPECT_TRUE(status.stable());
  EXPECT_FALSE(status.fallen());
}

TEST_P(MotionSolutionTest, framesThatWereMissedAreMadeUpFor) {
  motion_.set(robotlink::kMotionRequest, walking(0.1));
  motion_.run(200);
  const double before = motion_.sent(robotlink::kMotionStatus)->odometry().x();
  motion_.pass(0.016);
  motion_.run(1);
  EXPECT_NEAR(motion_.sent(robotlink::kMotionStatus)->odometry().x() - before, 0.1 * 0.024, 1e-9);
}

TEST_P(MotionSolutionTest, everyShippedMotionCanBeRequested) {
  motion_.run(100);
  for (const char* name :
       {"kick-forward", "kick-left", "kick-right", "sit", "stand", "get-up-back", "get-up-left"}) {
    robotcontrol::MotionRequest request;
    request.set_kind(robotcontrol::MotionRequest::KEY_FRAMES);
    request.set_motion(name);
    motion_.set(robotlink::kMotionRequest, request);
    motion_.run(30);
    EXPECT_EQ(motion_.sent(robotlink::kMotionStatus)->executed().motion(), name);
    motion_.set(robotlink::kMotionRequest, robotcontrol::MotionRequest());
    motion_.run(500);
    EXPECT_TRUE(motion_.sent(robotlink::kMotionStatus)->stable()) << name;
  }
}

TEST_P(MotionSolutionTest, motionsThatAreSentArePlayedFromThenOn) {
  motion_.run(100);
  const int pan = motion_.robot().description.jointIndex("headPan");
  const auto sendLook = [&](const std::string& text) {
    robotcontrol::MotionTexts texts;
    auto& look = *texts.add_motions();
    look.set_name("look");
    look.set_text(text);
    motion_.set(robotlink::kMotionTexts, texts);
  };
  const auto playLook = [&] {
    robotcontrol::MotionRequest request;
    request.set_kind(robotcontrol::MotionRequest::KEY_FRAMES);
    request.set_motion("look");
    motion_.set(robotlink::kMotionRequest, request);
    motion_.run(60);
    const double angle = motion_.sent(robotlink::kJointRequest)->positions(pan);
    motion_.set(robotlink::kMotionRequest, robotcontrol::MotionRequest());
    motion_.run(400);
    return angle;
  };
  const auto lookAt = [](const char* degrees) {
    return "motion_id = look\njoints = headPan\nlabel start\n" + std::string(degrees) +
           " 1 80\n* 1 1000\ntransition allMotions extern start\n";
  };
  sendLook(lookAt("45"));
  EXPECT_NEAR(playLook(), robotlink::radians(45), 1e-6);
  sendLook(lookAt("-30"));
  EXPECT_NEAR(playLook(), robotlink::radians(-30), 1e-6);
  // What does not compile is logged, and leaves the robot what it has.
  static_cast<void>(motion_.takeReported());
  sendLook("motion_id = look\nlabel start\n1 2 3\n");
  EXPECT_NEAR(playLook(), robotlink::radians(-30), 1e-6);
  const auto reported = motion_.takeReported();
  EXPECT_TRUE(std::ranges::any_of(reported, [](const auto& text) { return text.starts_with("look.mof:3"); }));
}

TEST_P(MotionSolutionTest, jointsAreTurnedByTheirNames) {
  motion_.run(100);
  const auto& description = motion_.robot().description;
  robotcontrol::MotionRequest request;
  request.set_kind(robotcontrol::MotionRequest::JOINTS);
  const auto turn = [&](const char* joint, double angle) {
    auto& target = *request.add_joints();
    target.set_name(joint);
    target.set_position(angle);
  };
  turn("tailPan", 0.25);
  turn("legFL2", 9);
  turn("wing", 1);
  motion_.set(robotlink::kMotionRequest, request);
  motion_.run(200);
  const auto& sent = *motion_.sent(robotlink::kJointRequest);
  EXPECT_NEAR(sent.positions(description.jointIndex("tailPan")), 0.25, 1e-9);
  EXPECT_NEAR(sent.positions(description.jointIndex("legFL2")), robotlink::radians(89), 1e-9);
  EXPECT_EQ(motion_.sent(robotlink::kMotionStatus)->executed().kind(), robotcontrol::MotionRequest::JOINTS);
  EXPECT_TRUE(motion_.takeReported().contains("the robot has no joint 'wing'"));
  request.set_limp(true);
  motion_.set(robotlink::kMotionRequest, request);
  motion_.run(5);
  EXPECT_EQ(motion_.sent(robotlink::kJointRequest)->stiffness(), 0);
  EXPECT_NEAR(motion_.sent(robotlink::kJointRequest)->positions(description.jointIndex("legFL2")),
              description.joints[static_cast<std::size_t>(description.jointIndex("legFL2"))].stance, 1e-9)
      << "where it is measured";
}

TEST_P(MotionSolutionTest, anUnknownMotionIsToldOnce) {
  robotcontrol::MotionRequest request;
  request.set_kind(robotcontrol::MotionRequest::KEY_FRAMES);
  request.set_motion("dance");
  motion_.set(robotlink::kMotionRequest, request);
  motion_.run(5);
  EXPECT_TRUE(motion_.takeReported().contains("there is no motion 'dance'"));
  motion_.run(5);
  EXPECT_FALSE(motion_.takeReported().contains("there is no motion 'dance'"));
}

TEST_P(MotionSolutionTest, whatIsSwitchedOnIsToldAndNothingElse) {
  motion_.set(robotlink::kMotionRequest, walking(0.1));
  motion_.run(10);
  const auto reported = motion_.takeReported();
  EXPECT_TRUE(std::ranges::none_of(
      reported, [](const auto& path) { return path.find("motion/") != std::string::npos; }));
  motion_.switchOnKeys();
  motion_.run(10);
  std::string all;
  for (const std::string& path : motion_.takeReported()) all += path + "\n";
  for (const char* part : {"motion/paws", "motion/speed/requested-x", "motion/phase", "motion/upright",
                           "motion/odometry/heading", "motion/joint-errors/legFL1"}) {
    EXPECT_NE(all.find(part), std::string::npos) << part << " in\n" << all;
  }
}

TEST_P(MotionSolutionTest, theHeadFollowsItsRequest) {
  robotcontrol::HeadRequest head;
  head.set_pan(0.5);
  head.set_tilt(-0.3);
  motion_.set(robotlink::kHeadRequest, head);
  motion_.run(100);
  const auto& description = motion_.robot().description;
  EXPECT_NEAR(motion_.sent(robotlink::kJointRequest)->positions(description.jointIndex("headPan")), 0.5,
              1e-9);
  EXPECT_NEAR(motion_.sent(robotlink::kJointRequest)->positions(description.jointIndex("neckTilt")), -0.3,
              1e-9);
}

INSTANTIATE_TEST_SUITE_P(Gaits, MotionSolutionTest,
                         testing::Values("wheel-model-rectangle", "wheel-model-half-ellipse"));

robotcontrol::BallModel ballAt(double x, double y, double age) {
  robotcontrol::BallModel ball;
  ball.set_known(true);
  ball.mutable_position_in_robot()->set_x(x);
  ball.mutable_position_in_robot()->set_y(y);
  ball.set_seconds_since_seen(age);
  return ball;
}

TEST(HeadControlSolutionTest, searchAndTrackLooksAtTheBallAndSearchesALostOne) {
  DogSolution head("head-control", "search-and-track");
  robotcontrol::HeadMode mode;
  mode.set_kind(robotcontrol::HeadMode::TRACK_BALL);
  head.set(robotlink::kHeadMode, mode);
  head.set(robotlink::kJointStates, jointsAtStance(head.robot().description));
  head.set(robotlink::kBallModel, ballAt(1, 0.5, 0));
  head.run(2);
  EXPECT_NEAR(head.sent(robotlink::kHeadRequest)->pan(), 0.5, 0.1);
  head.switchOnKeys("head-control/state");
  head.switchOnKeys("head-control/gaze");
  head.set(robotlink::kBallModel, ballAt(1, 0.5, 3));
  head.run(5);
  const auto reported = head.takeReported();
  EXPECT_TRUE(
      std::ranges::any_of(reported, [](const auto& path) { return path.ends_with("head-control/state"); }));
  EXPECT_TRUE(
      std::ranges::any_of(reported, [](const auto& path) { return path.ends_with("head-control/gaze"); }));
}

TEST(HeadControlSolutionTest, lookAroundSweepsWhateverIsAskedForButObeysAngles) {
  DogSolution head("head-control", "look-around");
  robotcontrol::HeadMode mode;
  mode.set_kind(robotcontrol::HeadMode::TRACK_BALL);
  head.set(robotlink::kHeadMode, mode);
  head.set(robotlink::kJointStates, jointsAtStance(head.robot().description));
  head.set(robotlink::kBallModel, ballAt(1, -0.5, 0));
  head.run(20);
  EXPECT_GT(head.sent(robotlink::kHeadRequest)->pan(), 0.1);
  mode.set_kind(robotcontrol::HeadMode::ANGLES);
  mode.set_pan(-0.7);
  head.set(robotlink::kHeadMode, mode);
  head.run(1);
  EXPECT_EQ(head.sent(robotlink::kHeadRequest)->pan(), -0.7);
}

}  // namespace
}  // namespace modules
