// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>

#include "MotionParameters.pb.h"
#include "foxglove/Robot.pb.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotcontrol/Motion.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/debugging/Solution.h"

namespace modules {
namespace {

/// What a process gives to one solution: inputs that a test sets, outputs that it reads.
class OneSolution final : public robotlink::SolutionContext {
 public:
  OneSolution(const std::string& task, const std::string& name)
      : debug_("motion", clock_, {}), description_(robotlink::SolutionRegistry::find(task, name)) {
    setenv("ROBOTCONTROL_RESOURCES", ROBOTCONTROL_SOURCE_DIR "/resources", 1);
    setup_.name = "red1";
    setup_.description =
        *robotlink::readRobotDescription(ROBOTCONTROL_SOURCE_DIR "/resources/robots/ers210.yaml");
    parameters_.reset(description_->parameters->New());
    for (const auto* names : {&description_->required, &description_->optional}) {
      for (const std::string& package : *names) slots_[package];
    }
    solution_ = description_->create(*this);
  }

  template <typename T>
  void set(robotlink::Package<T> package, T value) {
    slots_.at(package.name) = {std::make_shared<const T>(std::move(value)), true};
  }
  template <typename T>
  const T& sent(robotlink::Package<T> package) const {
    return *static_cast<const T*>(outputs_.at(package.name).get());
  }
  void execute(int frames) {
    for (int i = 0; i < frames; ++i) {
      clock_.advance(std::chrono::milliseconds(8));
      debug_.beginFrame(clock_.now(), static_cast<std::uint64_t>(++frame_));
      solution_->execute();
      debug_.endFrame();
    }
  }
  /// Time goes by without the solution.
  void pass(robotlink::Duration time) { clock_.advance(time); }
  void switchOn(const char* key) {
    robotcontrol::KeyMode mode;
    mode.set_kind(robotcontrol::KeyMode::ALWAYS);
    for (const int index : description_->keys) {
      if (robotlink::DebugKey::all()[static_cast<std::size_t>(index)].name == key)
        debug_.setMode(index, mode);
    }
  }
  /// The paths and texts of all that was told.
  std::set<std::string> reported() {
    std::set<std::string> result;
    while (debug_.hasQueue()) {
      const auto queue = debug_.takeQueue();
      for (const auto& message : queue->messages) {
        result.insert(message.path);
        if (const auto* text = message.as<foxglove::Log>()) result.insert(text->message());
      }
    }
    return result;
  }

  const robotlink::RobotSetup& robot() const override { return setup_; }
  const robotlink::Clock& clock() const override { return clock_; }
  robotlink::DebugContext& debug() override { return debug_; }
  const robotlink::SolutionDescription& description() const { return *description_; }

 protected:
  const robotlink::PackageSlot& inputSlot(const char* package) override { return slots_.at(package); }
  std::function<void(robotlink::PackagePtr)> outputSend(const char* package) override {
    return [this, name = std::string(package)](robotlink::PackagePtr value) {
      outputs_[name] = std::move(value);
    };
  }
  const google::protobuf::Message& parameterMessage() override { return *parameters_; }

 private:
  robotlink::ManualClock clock_;
  robotlink::DebugContext debug_;
  const robotlink::SolutionDescription* description_;
  robotlink::RobotSetup setup_;
  std::unique_ptr<google::protobuf::Message> parameters_;
  std::map<std::string, robotlink::PackageSlot> slots_;
  std::map<std::string, robotlink::PackagePtr> outputs_;
  std::unique_ptr<robotlink::Solution> solution_;
  int frame_ = 0;
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
  OneSolution motion_;
};

TEST_P(MotionSolutionTest, aWalkMovesTheLegsAndIsTold) {
  motion_.set(robotlink::kMotionRequest, walking(0.1));
  motion_.execute(200);
  const auto& joints = motion_.sent(robotlink::kJointRequest);
  ASSERT_EQ(joints.positions_size(), static_cast<int>(motion_.robot().description.joints.size()));
  EXPECT_EQ(joints.stiffness(), 1);
  const auto& status = motion_.sent(robotlink::kMotionStatus);
  EXPECT_EQ(status.executed().kind(), robotcontrol::MotionRequest::WALK);
  EXPECT_NEAR(status.velocity().x(), 0.1, 1e-9);
  EXPECT_NEAR(status.odometry().x(), 0.1 * (1.6 - 0.5) - 0.0125, 0.01);
  EXPECT_TRUE(status.stable());
  EXPECT_FALSE(status.fallen());
}

TEST_P(MotionSolutionTest, framesThatWereMissedAreMadeUpFor) {
  motion_.set(robotlink::kMotionRequest, walking(0.1));
  motion_.execute(200);
  const double before = motion_.sent(robotlink::kMotionStatus).odometry().x();
  motion_.pass(std::chrono::milliseconds(16));
  motion_.execute(1);
  EXPECT_NEAR(motion_.sent(robotlink::kMotionStatus).odometry().x() - before, 0.1 * 0.024, 1e-9);
}

TEST_P(MotionSolutionTest, everyShippedMotionCanBeRequested) {
  motion_.execute(100);
  for (const char* name :
       {"kick-forward", "kick-left", "kick-right", "sit", "stand", "get-up-back", "get-up-left"}) {
    robotcontrol::MotionRequest request;
    request.set_kind(robotcontrol::MotionRequest::KEY_FRAMES);
    request.set_motion(name);
    motion_.set(robotlink::kMotionRequest, request);
    motion_.execute(30);
    EXPECT_EQ(motion_.sent(robotlink::kMotionStatus).executed().motion(), name);
    motion_.set(robotlink::kMotionRequest, robotcontrol::MotionRequest());
    motion_.execute(500);
    EXPECT_TRUE(motion_.sent(robotlink::kMotionStatus).stable()) << name;
  }
}

TEST_P(MotionSolutionTest, anUnknownMotionIsToldOnce) {
  robotcontrol::MotionRequest request;
  request.set_kind(robotcontrol::MotionRequest::KEY_FRAMES);
  request.set_motion("dance");
  motion_.set(robotlink::kMotionRequest, request);
  motion_.execute(5);
  EXPECT_TRUE(motion_.reported().contains("there is no motion 'dance'"));
  motion_.execute(5);
  EXPECT_FALSE(motion_.reported().contains("there is no motion 'dance'"));
}

TEST_P(MotionSolutionTest, whatIsSwitchedOnIsToldAndNothingElse) {
  motion_.set(robotlink::kMotionRequest, walking(0.1));
  motion_.execute(10);
  EXPECT_TRUE(std::ranges::none_of(
      motion_.reported(), [](const auto& path) { return path.find("motion/") != std::string::npos; }));
  for (const int index : motion_.description().keys) {
    motion_.switchOn(robotlink::DebugKey::all()[static_cast<std::size_t>(index)].name.c_str());
  }
  motion_.execute(10);
  std::string all;
  for (const std::string& path : motion_.reported()) all += path + "\n";
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
  motion_.execute(100);
  const auto& description = motion_.robot().description;
  EXPECT_NEAR(motion_.sent(robotlink::kJointRequest).positions(description.jointIndex("headPan")), 0.5, 1e-9);
  EXPECT_NEAR(motion_.sent(robotlink::kJointRequest).positions(description.jointIndex("neckTilt")), -0.3,
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
  OneSolution head("head-control", "search-and-track");
  robotcontrol::HeadMode mode;
  mode.set_kind(robotcontrol::HeadMode::TRACK_BALL);
  head.set(robotlink::kHeadMode, mode);
  head.set(robotlink::kJointStates, jointsAtStance(head.robot().description));
  head.set(robotlink::kBallModel, ballAt(1, 0.5, 0));
  head.execute(2);
  EXPECT_NEAR(head.sent(robotlink::kHeadRequest).pan(), 0.5, 0.1);
  head.switchOn("head-control/state");
  head.switchOn("head-control/gaze");
  head.set(robotlink::kBallModel, ballAt(1, 0.5, 3));
  head.execute(5);
  const auto reported = head.reported();
  EXPECT_TRUE(
      std::ranges::any_of(reported, [](const auto& path) { return path.ends_with("head-control/state"); }));
  EXPECT_TRUE(
      std::ranges::any_of(reported, [](const auto& path) { return path.ends_with("head-control/gaze"); }));
}

TEST(HeadControlSolutionTest, lookAroundSweepsWhateverIsAskedForButObeysAngles) {
  OneSolution head("head-control", "look-around");
  robotcontrol::HeadMode mode;
  mode.set_kind(robotcontrol::HeadMode::TRACK_BALL);
  head.set(robotlink::kHeadMode, mode);
  head.set(robotlink::kJointStates, jointsAtStance(head.robot().description));
  head.set(robotlink::kBallModel, ballAt(1, -0.5, 0));
  head.execute(20);
  EXPECT_GT(head.sent(robotlink::kHeadRequest).pan(), 0.1);
  mode.set_kind(robotcontrol::HeadMode::ANGLES);
  mode.set_pan(-0.7);
  head.set(robotlink::kHeadMode, mode);
  head.execute(1);
  EXPECT_EQ(head.sent(robotlink::kHeadRequest).pan(), -0.7);
}

}  // namespace
}  // namespace modules
