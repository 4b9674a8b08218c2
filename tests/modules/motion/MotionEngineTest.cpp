// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/motion/MotionEngine.h"

#include <gtest/gtest.h>

#include "robotlink/motions/MotionReader.h"

namespace modules {
namespace {

using robotlink::Vector3;

std::vector<robotlink::RobotDescription::Joint> joints() {
  std::vector<robotlink::RobotDescription::Joint> result;
  for (const char* name : {"neckTilt", "headPan", "headRoll", "mouth"})
    result.push_back({name, -1.4, 1.5, 2.0, 0});
  for (const char* leg : {"legFR", "legFL", "legHR", "legHL"}) {
    for (const char* number : {"1", "2", "3"})
      result.push_back({std::string(leg) + number, -2, 2.5, 2.8, 0.4});
  }
  result.push_back({"tailPan", -0.4, 0.4, 4, 0.2});
  return result;
}

std::shared_ptr<const robotlink::MotionNet> motions() {
  std::vector<robotlink::MotionFile> files;
  std::string table = "motion_id = extern\nlabel start\n";
  for (const char* name : {"kick", "kick-at-once", "get-up-left"}) {
    const std::string text = std::string("motion_id = ") + name + "\njoints = legFL1 legFR1\n" +
                             (name == std::string("kick-at-once") ? "begin = walk\n" : "") +
                             "odometry = 20 -5 30\nlabel start\n57.2958 0 1 160\n0 0 1 160\n"
                             "transition allMotions extern start\n";
    files.push_back(robotlink::readMotion(text, name).value());
    table += std::string("transition ") + name + " " + name + " start\n";
  }
  files.push_back(robotlink::readMotion(table + "transition extern extern start\n", "extern").value());
  std::vector<std::string> names;
  for (const auto& joint : joints()) names.push_back(joint.name);
  return robotlink::compileMotions(files, names).value();
}

class MotionEngineTest : public testing::Test {
 protected:
  void run(const MotionCommand& desired, int frames, const Vector3& acceleration = {0, 0, 9.8}) {
    for (int i = 0; i < frames; ++i) {
      const std::vector<double> before(engine_.positions().begin(), engine_.positions().end());
      engine_.advance({desired, head_, &acceleration, std::chrono::milliseconds(8)});
      for (std::size_t j = 0; j < before.size(); ++j) {
        largestStep_ = std::max(largestStep_, std::abs(before[j] - engine_.positions()[j]));
      }
    }
  }
  double angle(const char* joint) const {
    const auto all = joints();
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all[i].name == joint) return engine_.positions()[i];
    }
    return NAN;
  }
  static MotionCommand walk(double x) { return {MotionCommand::Kind::kWalk, {x, 0, 0}, {}}; }
  static MotionCommand keyFrames(const char* motion) { return {MotionCommand::Kind::kKeyFrames, {}, motion}; }

  MotionEngine engine_{*JointLayout::of(joints()), motions(), GaitParameters{}, MotionEngine::Options{}};
  HeadAngles head_;
  double largestStep_ = 0;
};

TEST_F(MotionEngineTest, itGoesSoftlyFromAnyPostureToTheStand) {
  engine_.start(std::vector<double>(joints().size(), 0.0));
  run({}, 100);
  EXPECT_LT(largestStep_, 0.12);
  EXPECT_TRUE(engine_.stable());
  EXPECT_EQ(engine_.executed().kind, MotionCommand::Kind::kStand);
  EXPECT_NEAR(angle("legFL1"), engine_.gait().angles(Leg::kFrontLeft).swing, 1e-12);
  EXPECT_NEAR(angle("tailPan"), 0.2, 1e-12);
}

TEST_F(MotionEngineTest, odometryAddsUpTheWalk) {
  run({}, 100);
  run(walk(0.1), 250);
  EXPECT_EQ(engine_.executed().kind, MotionCommand::Kind::kWalk);
  EXPECT_NEAR(engine_.odometry().x, 2.0 * 0.1 - 0.0125, 0.003);
  EXPECT_EQ(engine_.speed().x, 0.1);
}

TEST_F(MotionEngineTest, aMotionMovesTheOdometryByWhatItsFileSays) {
  run({}, 100);
  run(keyFrames("kick"), 20);
  EXPECT_NEAR(engine_.odometry().heading, robotlink::radians(15), robotlink::radians(1))
      << "half of it is played";
  run({}, 100);
  EXPECT_NEAR(engine_.odometry().x, 0.02, 1e-12);
  EXPECT_NEAR(engine_.odometry().y, -0.005, 1e-12);
  EXPECT_NEAR(engine_.odometry().heading, robotlink::radians(30), 1e-12);
}

TEST_F(MotionEngineTest, aWalkStandsBeforeKeyFramesBeginAndThenGoesOn) {
  run({}, 100);
  run(walk(0.1), 100);
  run(keyFrames("kick"), 1);
  EXPECT_EQ(engine_.executed().kind, MotionCommand::Kind::kWalk);
  for (int i = 0; i < 70 && engine_.executed().kind == MotionCommand::Kind::kWalk; ++i)
    run(keyFrames("kick"), 1);
  run(keyFrames("kick"), 20);
  EXPECT_EQ(engine_.executed(), keyFrames("kick"));
  EXPECT_FALSE(engine_.stable());
  run(walk(0.1), 2);
  EXPECT_EQ(engine_.executed(), keyFrames("kick")) << "a motion is left at its end only";
  run(walk(0.1), 200);
  EXPECT_EQ(engine_.executed().kind, MotionCommand::Kind::kWalk);
  EXPECT_LT(largestStep_, 0.12);
}

TEST_F(MotionEngineTest, aMotionThatBeginsInAWalkWaitsForTheEndOfTheStepOnly) {
  run({}, 100);
  for (int waited = 0; waited < 20; ++waited) {
    run(walk(0.1), 100 + waited);
    int frames = 0;
    for (; frames < 100 && engine_.executed().kind == MotionCommand::Kind::kWalk; ++frames)
      run(keyFrames("kick-at-once"), 1);
    EXPECT_EQ(engine_.executed(), keyFrames("kick-at-once"));
    EXPECT_LE(frames, GaitParameters{}.stepFrames / 2 + 1);
    const double phase = 2 * engine_.gait().phase();
    EXPECT_LT(phase - std::floor(phase), 2.1 / GaitParameters{}.stepFrames) << "all paws are down";
    run({}, 200);
  }
}

TEST_F(MotionEngineTest, aMotionThatIsWantedAllTheTimeIsRepeatedAfterAStand) {
  run({}, 100);
  std::string reported;
  for (int i = 0; i < 250; ++i) {
    run(keyFrames("kick"), 1);
    const char state = engine_.executed().kind == MotionCommand::Kind::kKeyFrames ? 'k' : 's';
    if (reported.empty() || reported.back() != state) reported += state;
  }
  EXPECT_EQ(reported, "ksksks");
  EXPECT_LT(largestStep_, 0.12);
}

TEST_F(MotionEngineTest, unknownMotionsAreRefusedWithTheirName) {
  run(keyFrames("dance"), 10);
  EXPECT_EQ(engine_.refusal(), "there is no motion 'dance'");
  EXPECT_EQ(engine_.executed().kind, MotionCommand::Kind::kStand);
  run(walk(0), 1);
  EXPECT_EQ(engine_.refusal(), "");
}

TEST_F(MotionEngineTest, aFallenRobotGetsUpBeforeItObeys) {
  run({}, 100);
  run(walk(0.1), 150, {0, -9.8, 0});
  EXPECT_TRUE(engine_.falls().fallen());
  EXPECT_EQ(engine_.executed().kind, MotionCommand::Kind::kGetUp);
  EXPECT_EQ(engine_.executed().motion, "get-up-left");
  run(walk(0.1), 200);
  EXPECT_EQ(engine_.executed().kind, MotionCommand::Kind::kWalk);
}

TEST_F(MotionEngineTest, aFallToASideWithoutAMotionIsToldAndNothingIsDone) {
  run(walk(0.1), 150, {0, 9.8, 0});
  EXPECT_TRUE(engine_.falls().fallen());
  EXPECT_EQ(engine_.refusal(), "there is no motion 'get-up-right'");
}

TEST_F(MotionEngineTest, theHeadGoesAsFastAsItsJointsAndNoFurther) {
  head_ = {0.3, 9, 0, 0};
  run({}, 1);
  EXPECT_NEAR(angle("headPan"), 2.0 * 0.9 * 0.008, 1e-12);
  run({}, 200);
  EXPECT_NEAR(angle("neckTilt"), 0.3, 1e-12);
  EXPECT_NEAR(angle("headPan"), 1.5, 1e-12);
  head_.pan = NAN;
  run({}, 10);
  EXPECT_NEAR(angle("headPan"), 1.5, 1e-12);
}

TEST_F(MotionEngineTest, aDescriptionWithoutLegsIsRefused) {
  auto some = joints();
  some.pop_back();
  some.pop_back();
  const auto layout = JointLayout::of(some);
  ASSERT_FALSE(layout);
  EXPECT_EQ(layout.error().arguments[0], "legHL3");
}

TEST_F(MotionEngineTest, singleJointsTurnWithinTheirLimitsAndTheOthersHold) {
  run({}, 200);
  const double other = angle("legFR1");
  MotionCommand command{MotionCommand::Kind::kJoints, {}, {}, std::vector<double>(17, NAN)};
  command.joints[7] = 99;   // legFL1
  command.joints[1] = 0.5;  // headPan
  run(command, 1);
  EXPECT_EQ(engine_.executed().kind, MotionCommand::Kind::kJoints);
  EXPECT_FALSE(engine_.stable());
  largestStep_ = 0;
  run(command, 300);
  EXPECT_DOUBLE_EQ(angle("legFL1"), 2.5);
  EXPECT_DOUBLE_EQ(angle("headPan"), 0.5);
  EXPECT_DOUBLE_EQ(angle("legFR1"), other);
  EXPECT_LE(largestStep_, 2.8 * 0.008 + 1e-9);
  run({}, 300);
  EXPECT_EQ(engine_.executed().kind, MotionCommand::Kind::kStand);
  EXPECT_NEAR(angle("legFL1"), angle("legFR1"), 1e-6);
  EXPECT_LT(largestStep_, 0.12);
}

TEST_F(MotionEngineTest, aWalkStopsBeforeJointsTurn) {
  run(walk(0.1), 200);
  const MotionCommand command{MotionCommand::Kind::kJoints, {}, {}, std::vector<double>(17, NAN)};
  run(command, 1);
  EXPECT_EQ(engine_.executed().kind, MotionCommand::Kind::kWalk);
  run(command, 300);
  EXPECT_EQ(engine_.executed().kind, MotionCommand::Kind::kJoints);
}

TEST_F(MotionEngineTest, limpJointsFollowTheHandAndDoNotGetUp) {
  run({}, 200);
  MotionCommand limp;
  limp.kind = MotionCommand::Kind::kJoints;
  limp.limp = true;
  const std::vector<double> posed(17, 0.25);
  const Vector3 lying{0, 9.8, 0};
  for (int i = 0; i < 200; ++i) engine_.advance({limp, head_, &lying, std::chrono::milliseconds(8), posed});
  EXPECT_EQ(engine_.stiffness(), 0);
  EXPECT_EQ(engine_.executed().kind, MotionCommand::Kind::kJoints);
  EXPECT_DOUBLE_EQ(angle("legHL3"), 0.25);
  limp.limp = false;
  largestStep_ = 0;
  run(limp, 10, lying);
  EXPECT_EQ(engine_.stiffness(), 1);
  EXPECT_EQ(largestStep_, 0);
}

TEST_F(MotionEngineTest, motionsAreReplacedBetweenTwoMotionsNotWithinOne) {
  run({}, 200);
  run(keyFrames("kick"), 10);
  EXPECT_EQ(engine_.executed().motion, "kick");
  auto other = std::make_shared<robotlink::MotionNet>(*motions());
  for (auto& node : other->nodes) {
    if (auto* frame = std::get_if<robotlink::KeyFrame>(&node.step)) frame->joints[7].angle = -1;
  }
  engine_.setMotions(other);
  run(keyFrames("kick"), 10);
  EXPECT_GT(angle("legFL1"), 0.5) << "the one that had begun";
  run({}, 300);
  run(keyFrames("kick"), 20);
  EXPECT_LT(angle("legFL1"), -0.5) << "the new one";
}

}  // namespace
}  // namespace modules
