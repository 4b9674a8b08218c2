// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <array>
#include <fstream>

#include "robotlink/base/Random.h"
#include "tests/TestFolder.h"
#include "tests/modules/motion/WalkingRobot.h"

namespace modules {
namespace {

const std::filesystem::path kResources = ROBOTCONTROL_SOURCE_DIR "/resources";

WalkingRobot::Options options(FootMode mode = FootMode::kRectangle) {
  WalkingRobot::Options options;
  options.resources = kResources;
  options.gait = shippedGait(kResources, mode);
  return options;
}

MotionCommand keyFrames(const std::string& motion) {
  return {MotionCommand::Kind::kKeyFrames, {}, motion};
}

struct SpeedCase {
  const char* name;
  WalkSpeed speed;
};

class WalkingSpeedTest : public testing::TestWithParam<std::tuple<FootMode, SpeedCase>> {};

/// What is asked for is measured within 20 %, and the other directions are as still as 20 % of a slow walk.
TEST_P(WalkingSpeedTest, measuredVelocitiesAreThoseRequested) {
  const WalkSpeed wanted = std::get<1>(GetParam()).speed;
  WalkingRobot robot(options(std::get<0>(GetParam())));
  robot.placeBall({-1, 1});
  const auto measured = robot.walk(wanted, 5);
  EXPECT_NEAR(measured.speed.x, wanted.x, std::max(0.2 * std::abs(wanted.x), 0.012));
  EXPECT_NEAR(measured.speed.y, wanted.y, std::max(0.2 * std::abs(wanted.y), 0.012));
  EXPECT_NEAR(measured.speed.rotation, wanted.rotation, std::max(0.2 * std::abs(wanted.rotation), 0.08));
  EXPECT_GT(measured.leastUpright, 0.98);
}

INSTANTIATE_TEST_SUITE_P(
    Speeds, WalkingSpeedTest,
    testing::Combine(testing::Values(FootMode::kRectangle, FootMode::kHalfEllipse),
                     testing::Values(SpeedCase{"slow", {0.05, 0, 0}}, SpeedCase{"forward", {0.1, 0, 0}},
                                     SpeedCase{"fast", {0.15, 0, 0}}, SpeedCase{"backward", {-0.1, 0, 0}},
                                     SpeedCase{"fastBackward", {-0.15, 0, 0}}, SpeedCase{"left", {0, 0.1, 0}},
                                     SpeedCase{"farLeft", {0, 0.15, 0}}, SpeedCase{"right", {0, -0.1, 0}},
                                     SpeedCase{"turnSlowly", {0, 0, 0.3}}, SpeedCase{"turn", {0, 0, 1}},
                                     SpeedCase{"turnRight", {0, 0, -1}}, SpeedCase{"curve", {0.08, 0, 0.5}},
                                     SpeedCase{"everything", {0.06, -0.05, 0.4}})),
    [](const auto& test) {
      const bool rectangle = std::get<0>(test.param) == FootMode::kRectangle;
      return std::string(rectangle ? "rectangle_" : "ellipse_") + std::get<1>(test.param).name;
    });

TEST(WalkingTest, aMinuteOfChangingRequestsIsWalkedWithoutAFall) {
  WalkingRobot robot(options());
  robot.placeBall({-1, 1});
  robotlink::Random random(5);
  for (int i = 0; i < 40; ++i) {
    robot.placeRobot({0, 0, random.uniform(-3, 3)});
    const WalkSpeed speed{random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), random.uniform(-1.5, 1.5)};
    robot.run(i % 5 == 4 ? MotionCommand{} : MotionCommand{MotionCommand::Kind::kWalk, speed, {}}, 1.5);
    ASSERT_GT(robot.upright(), 0.95) << i;
    ASSERT_FALSE(robot.engine().falls().fallen()) << i;
  }
}

WalkingRobot::Options fastOptions(std::uint64_t seed) {
  WalkingRobot::Options options;
  options.resources = kResources;
  options.gait = shippedGait(kResources, "wheel-model-fast", FootMode::kRectangle);
  options.seed = seed;
  return options;
}

TEST(FastGaitTest, walksMuchFasterThanTheDefaultAndStraight) {
  WalkingRobot usual(options()), fast(fastOptions(7));
  usual.placeBall({-1, 1});
  fast.placeBall({-1, 1});
  const auto before = usual.walk({1, 0, 0}, 4), now = fast.walk({1, 0, 0}, 4);
  EXPECT_GT(now.speed.x, 1.15 * before.speed.x);
  EXPECT_NEAR(now.speed.x, fast.engine().speed().x, 0.1 * now.speed.x) << "odometry";
  EXPECT_NEAR(now.speed.y, 0, 0.02);
  EXPECT_NEAR(now.speed.rotation, 0, 0.05);
  EXPECT_GT(now.leastUpright, 0.98);
}

/// How far a ball that lies there rolls in 4 s from the begin of a kick, in the frame of the robot before it,
/// which stands again upright after `seconds`.
robotlink::Vector2 kicked(const std::string& motion, const robotlink::Vector2& ball, double tilt,
                          double seconds) {
  WalkingRobot robot(fastOptions(1));
  robot.head() = {tilt, 0, 0, 0};
  robot.run({}, 1);
  robot.placeBall(ball);
  robot.run({}, 0.2);
  const robotlink::Vector3 before = robot.ball();
  const robotlink::Pose2 stand = robotlink::groundPose(robot.pose());
  robot.run(keyFrames(motion), 0.3);
  robot.run({}, seconds - 0.3);
  EXPECT_TRUE(robot.engine().stable()) << motion;
  robot.run({}, 4 - seconds);
  EXPECT_GT(robot.upright(), 0.98) << motion;
  const robotlink::Vector3 way = robot.ball() - before;
  return Eigen::Rotation2Dd(-stand.heading) * robotlink::Vector2(way.x(), way.y());
}

TEST(FastGaitTest, kicksToTheSidesAreSquare) {
  for (const double side : {1.0, -1.0}) {
    const auto way = kicked(side > 0 ? "kick-to-left" : "kick-to-right", {0.166, side * 0.05}, -1.1, 1.3);
    EXPECT_GT(side * way.y(), 0.5);
    EXPECT_LT(std::abs(way.x()), 0.6 * std::abs(way.y()));
  }
}

TEST(FastGaitTest, theQuickKickIsStraightAndOverInASecond) {
  for (const robotlink::Vector2& ball :
       {robotlink::Vector2(0.158, 0), robotlink::Vector2(0.15, 0.02), robotlink::Vector2(0.168, -0.02)}) {
    const auto way = kicked("kick-quick", ball, -0.9, 1);
    EXPECT_GT(way.x(), 0.4) << ball;
    EXPECT_LT(std::abs(way.y()), 0.4 * way.x()) << ball;
  }
}

TEST(FastGaitTest, theFarKickIsStraightAndReachesMoreThanAMeter) {
  const std::array<robotlink::Vector2, 5> balls{
      {{0.143, 0}, {0.137, 0.02}, {0.15, -0.02}, {0.14, -0.01}, {0.147, 0.01}}};
  double sum = 0;
  for (const robotlink::Vector2& ball : balls) {
    const auto way = kicked("kick-far", ball, -0.9, 1.5);
    EXPECT_GT(way.x(), 0.5) << ball;
    EXPECT_LT(std::abs(way.y()), 0.4 * way.x()) << ball;
    sum += way.x();
  }
  EXPECT_GT(sum / static_cast<double>(balls.size()), 1);
}

TEST(WalkingTest, theSameRunGivesTheSameBytes) {
  std::uint64_t digests[2];
  for (std::uint64_t& digest : digests) {
    WalkingRobot robot(options());
    robot.run({MotionCommand::Kind::kWalk, {0.1, 0.02, 0.3}, {}}, 3);
    digest = robot.simulation().digest();
  }
  EXPECT_EQ(digests[0], digests[1]);
}

TEST(WalkingTest, odometryFollowsTheRobot) {
  WalkingRobot robot(options());
  robot.placeBall({-1, 1});
  robot.run({}, 1);
  const robotlink::Pose2 before = robotlink::groundPose(robot.pose());
  robot.run({MotionCommand::Kind::kWalk, {0.1, 0, 0.3}, {}}, 4);
  robot.run({}, 1);
  const robotlink::Pose2 moved = before.inverse() * robotlink::groundPose(robot.pose());
  const robotlink::Pose2& reported = robot.engine().odometry();
  EXPECT_LT((moved.translation() - reported.translation()).norm(), 0.06);
  EXPECT_NEAR(robotlink::normalizedAngle(moved.heading - reported.heading), 0, 0.2);
}

struct KickCase {
  const char* motion;
  robotlink::Vector2 ball;
};

class KickTest : public testing::TestWithParam<KickCase> {};

TEST_P(KickTest, theBallRollsHalfAMeterAndTheRobotStandsAgain) {
  WalkingRobot robot(options());
  robot.run({}, 1);
  robot.placeBall(GetParam().ball);
  robot.run({}, 0.2);
  const robotlink::Vector3 before = robot.ball();
  const robotlink::Pose2 stand = robotlink::groundPose(robot.pose());
  robot.run(keyFrames(GetParam().motion), 0.3);
  EXPECT_EQ(robot.engine().executed().motion, GetParam().motion);
  robot.run({}, 4);
  const robotlink::Vector3 way = robot.ball() - before;
  const double ahead = way.x() * std::cos(stand.heading) + way.y() * std::sin(stand.heading);
  EXPECT_GT(ahead, 0.5);
  EXPECT_GT(ahead, way.norm() * 0.85) << "straight ahead, more or less";
  EXPECT_GT(robot.upright(), 0.98);
  EXPECT_TRUE(robot.engine().stable());
}

INSTANTIATE_TEST_SUITE_P(Kicks, KickTest,
                         testing::Values(KickCase{"kick-forward", {0.155, 0}},
                                         KickCase{"kick-forward", {0.15, 0.015}},
                                         KickCase{"kick-forward", {0.165, -0.015}},
                                         KickCase{"kick-left", {0.165, 0.065}},
                                         KickCase{"kick-right", {0.165, -0.065}}));

/// The head looks down at a ball before the paws; a kick that did not raise it first would topple over it.
TEST(KickPostureTest, aKickThatBeginsWithTheHeadDownEndsOnFourPaws) {
  for (const double pan : {0.0, -1.2}) {
    WalkingRobot robot(options());
    robot.head() = {-1.2, pan, 0, 0};
    robot.run({MotionCommand::Kind::kWalk, {0.05, 0.02, 0}, {}}, 1.5);
    robot.placeBall({0.155, 0});
    robot.run(keyFrames("kick-forward"), 1);
    double least = 1;
    for (int i = 0; i < 500; ++i) {
      robot.frame({MotionCommand::Kind::kWalk, {0.1, 0, 0}, {}});
      least = std::min(least, robot.upright());
    }
    EXPECT_GT(least, 0.85);
  }
}

struct FallCase {
  const char* name;
  double roll, pitch;  // degrees
};

class GetUpTest : public testing::TestWithParam<FallCase> {
 protected:
  /// A world in which the robot begins lying.
  std::filesystem::path scene(const FallCase& fall) const {
    const auto file = folder_ / "fall.sdf";
    const auto model = [](const char* name, const std::string& pose, const char* rest) {
      return "<include><uri>" + (kResources / "scenes/models" / name).string() + "</uri><pose>" + pose +
             "</pose>" + rest + "</include>\n";
    };
    std::ofstream(file)
        << "<?xml version=\"1.0\"?>\n<sdf version=\"1.9\" xmlns:robotcontrol=\"urn:robotcontrol:sdf\">"
        << "<world name=\"fall\"><gravity>0 0 -9.81</gravity>\n"
        << model("field2002", "0 0 0 0 0 0", "") << model("ball", "1.5 1 0.0421 0 0 0", "")
        << model("ers210",
                 "0 0 0.16 " + std::to_string(robotlink::radians(fall.roll)) + " " +
                     std::to_string(robotlink::radians(fall.pitch)) + " 0",
                 "<name>red1</name>")
        << "</world></sdf>\n";
    return file;
  }
  const TestFolder folder_;
};

TEST_P(GetUpTest, theRobotGetsUpByItselfAndWalks) {
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    WalkingRobot::Options lying = options();
    lying.scene = scene(GetParam());
    lying.seed = seed;
    WalkingRobot robot(lying);
    robot.run({}, 0.7);
    ASSERT_LT(robot.upright(), 0.6) << "it does lie";
    double time = 0.7;
    while (time < 8 && !(robot.upright() > 0.98 && robot.engine().stable())) {
      robot.run({}, 0.1);
      time += 0.1;
    }
    RecordProperty("seconds", std::to_string(time));
    EXPECT_LT(time, 8);
    robot.run({MotionCommand::Kind::kWalk, {0.1, 0, 0}, {}}, 1.5);
    EXPECT_GT(robot.upright(), 0.98);
    EXPECT_GT(robot.engine().speed().x, 0.09);
  }
}

INSTANTIATE_TEST_SUITE_P(Sides, GetUpTest,
                         testing::Values(FallCase{"back", 180, 0}, FallCase{"left", -90, 0},
                                         FallCase{"right", 90, 0}, FallCase{"face", 0, 90},
                                         FallCase{"rump", 0, -90}),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace modules
