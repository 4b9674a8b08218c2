// SPDX-License-Identifier: GPL-3.0-or-later
// Motions that a person sends to the program of a simulated robot, and single joints that a person turns.
#include <gmock/gmock.h>

#include <cmath>
#include <map>

#include "app/core/program/ShippedFiles.h"
#include "foxglove/Robot.pb.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/Geometry.h"
#include "robotlink/base/Resources.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "tests/app/Requests.h"
#include "tests/app/SimulatedRuns.h"

using namespace app::test;
using app::SimulatedRun;
using ::testing::HasSubstr;

namespace {

using robotcontrol::MotionRequest;

robotcontrol::Request setMotion(const std::string& name, const std::string& text, std::uint64_t id) {
  robotcontrol::Request request;
  request.set_robot("red1");
  request.set_id(id);
  request.mutable_set_motion()->mutable_motion()->set_name(name);
  request.mutable_set_motion()->mutable_motion()->set_text(text);
  return request;
}

/// A motion that turns the head far to a side and stays there for a second.
std::string headTurn(const std::string& name, int degrees) {
  const std::string pan = std::to_string(degrees);
  return "motion_id = " + name + "\njoints = headPan\nlabel start\n" + pan + " 1 600\n" + pan +
         " 0 1000\ntransition allMotions extern start\n";
}

/// What a run publishes of red1.
struct Heard {
  std::map<std::string, double> angles;  // degrees
  std::map<std::uint64_t, robotcontrol::RequestResult> results;
  robotcontrol::MotionTable motions;
  double effort = 0;  // the greatest, N m
  SimulatedRun::Listeners listeners() {
    return {[this](const std::string& robot, const auto& queue) {
              if (robot != "red1") return;
              const auto wire = toWire(*queue);
              for (const auto& message : wire.messages()) hear(message);
            },
            {}};
  }
  void hear(const robotcontrol::DebugMessage& message) {
    if (message.has_result()) results.emplace(message.result().id(), message.result());
    if (message.path() == "tables/motions") motions.ParseFromString(message.package().data());
    if (message.path() != "joints/states") return;
    foxglove::JointStates states;
    states.ParseFromString(message.package().data());
    for (const auto& joint : states.joints()) {
      angles[joint.name()] = robotlink::degrees(joint.position());
      effort = std::max(effort, std::abs(joint.effort()));
    }
  }
  const robotcontrol::MotionTable::Motion* motion(const std::string& name) const {
    for (const auto& each : motions.motions()) {
      if (each.name() == name) return &each;
    }
    return nullptr;
  }
};

/// A run whose red1 obeys, stands, and publishes its joints.
struct Obeying {
  Obeying() : run(makeRun(simulationOptions(), heard.listeners())) {
    EXPECT_TRUE(run->request(selectRequest("red1", "behavior", "obey")).has_value());
    EXPECT_TRUE(run->request(keyRequest("red1", "package/joints/states")).has_value());
    play(*run, 1.5);
  }
  bool ask(const robotcontrol::Request& request) {
    EXPECT_TRUE(run->request(request).has_value());
    play(*run, 0.1);
    return heard.results[request.id()].accepted();
  }
  /// Commands a motion for some time, as manual control does.
  void command(const MotionRequest& motion, double seconds) {
    robotcontrol::Request request;
    request.set_robot("red1");
    *request.mutable_motion()->mutable_motion() = motion;
    for (double time = 0; time < seconds; time += 0.1) {
      EXPECT_TRUE(run->request(request).has_value());
      play(*run, 0.1);
    }
  }
  void playOnce(const std::string& motion, double seconds) {
    MotionRequest request;
    request.set_kind(MotionRequest::KEY_FRAMES);
    request.set_motion(motion);
    command(request, 0.2);
    command({}, 0.1);  // or it would be played again and again
    play(*run, seconds - 0.3);
  }
  void stand(double seconds) { command({}, seconds); }
  Heard heard;
  std::unique_ptr<SimulatedRun> run;
};

}  // namespace

TEST(SimulatedMotions, aMotionThatIsSentIsPlayedWithoutARestartAndAlsoAfterAReset) {
  Obeying robot;
  ASSERT_NE(robot.heard.motion("kick-left"), nullptr);
  EXPECT_FALSE(robot.heard.motion("kick-left")->sent());
  ASSERT_TRUE(robot.ask(setMotion("kick-left", headTurn("kick-left", 60), 7)))
      << robot.heard.results[7].reason();
  EXPECT_TRUE(robot.heard.motion("kick-left")->sent());
  robot.playOnce("kick-left", 1.2);
  EXPECT_NEAR(robot.heard.angles["headPan"], 60, 4);
  robot.stand(3);
  EXPECT_NEAR(robot.heard.angles["headPan"], 0, 4);

  EXPECT_TRUE(robot.run->reset(2).empty());
  play(*robot.run, 1.5);
  robot.playOnce("kick-left", 1.2);
  EXPECT_NEAR(robot.heard.angles["headPan"], 60, 4);
  robot.stand(3);

  // Taken back, it is that of the files again: this kick turns the head to the right.
  ASSERT_TRUE(robot.ask(setMotion("kick-left", "", 8)));
  EXPECT_FALSE(robot.heard.motion("kick-left")->sent());
  robot.playOnce("kick-left", 1.2);
  EXPECT_LT(robot.heard.angles["headPan"], 30);
}

TEST(SimulatedMotions, aNewMotionIsAddedToThoseOfTheRobot) {
  Obeying robot;
  ASSERT_TRUE(robot.ask(setMotion("look-left", headTurn("look-left", 45), 7)));
  robot.playOnce("look-left", 1.2);
  EXPECT_NEAR(robot.heard.angles["headPan"], 45, 4);
}

TEST(SimulatedMotions, aMotionThatDoesNotCompileIsRefusedWithItsLineAndChangesNothing) {
  Obeying robot;
  EXPECT_FALSE(robot.ask(setMotion("bow", "motion_id = bow\nlabel start\n1 2\n", 7)));
  EXPECT_THAT(robot.heard.results[7].reason(), HasSubstr("bow.mof:3"));
  EXPECT_FALSE(robot.ask(setMotion("bow",
                                   "motion_id = bow\njoints = wing\nlabel start\n1 1 100\n"
                                   "transition allMotions extern start\n",
                                   8)));
  EXPECT_THAT(robot.heard.results[8].reason(), HasSubstr("the robot has no joint 'wing'"));
  EXPECT_FALSE(robot.ask(setMotion("bow", headTurn("nod", 10), 9)));
  EXPECT_THAT(robot.heard.results[9].reason(), HasSubstr("is that of 'nod'"));
  EXPECT_FALSE(robot.ask(
      setMotion("extern", "motion_id = extern\nlabel begin\ntransition allMotions extern begin\n", 10)));
  EXPECT_EQ(robot.heard.motion("bow"), nullptr);
}

TEST(SimulatedMotions, inAPauseAMotionIsAcceptedAtOnceAndInTheTable) {
  Obeying robot;
  ASSERT_TRUE(robot.run->request(setMotion("look-left", headTurn("look-left", 45), 7)).has_value());
  robot.run->publishComingAnswers();
  EXPECT_TRUE(robot.heard.results[7].accepted());
  ASSERT_NE(robot.heard.motion("look-left"), nullptr);
  ASSERT_TRUE(robot.run->request(setMotion("bow", "nothing", 8)).has_value());
  robot.run->publishComingAnswers();
  EXPECT_FALSE(robot.heard.results[8].accepted());
  EXPECT_THAT(robot.heard.results[8].reason(), HasSubstr("bow.mof:1"));
}

TEST(SimulatedMotions, singleJointsTurnWithinTheirLimitsAndTheRobotTellsTheirTorques) {
  Obeying robot;
  MotionRequest request;
  request.set_kind(MotionRequest::JOINTS);
  auto& pan = *request.add_joints();
  pan.set_name("headPan");
  pan.set_position(10);
  auto& leg = *request.add_joints();
  leg.set_name("legFL2");
  leg.set_position(robotlink::radians(40));
  const double knee = robot.heard.angles["legHR3"];
  robot.command(request, 2);
  EXPECT_NEAR(robot.heard.angles["headPan"], 89.6, 3) << "the limit";
  EXPECT_NEAR(robot.heard.angles["legFL2"], 40, 5);
  EXPECT_NEAR(robot.heard.angles["legHR3"], knee, 6);
  EXPECT_GT(robot.heard.effort, 0);
  robot.stand(3);
  EXPECT_NEAR(robot.heard.angles["headPan"], 0, 3);
}

TEST(SimulatedMotions, aLimpRobotSinksDownAndHoldsWhereItIsAfterwards) {
  Obeying robot;
  MotionRequest request;
  request.set_kind(MotionRequest::JOINTS);
  request.set_limp(true);
  const auto before = robot.heard.angles;
  robot.command(request, 2);
  double moved = 0;
  for (const auto& [joint, angle] : robot.heard.angles)
    moved = std::max(moved, std::abs(angle - before.at(joint)));
  EXPECT_GT(moved, 10);
  request.set_limp(false);
  const auto limp = robot.heard.angles;
  robot.command(request, 1);
  for (const auto& [joint, angle] : robot.heard.angles) EXPECT_NEAR(angle, limp.at(joint), 6) << joint;
}

TEST(SimulatedMotions, theSameRequestsGiveTheSameBytes) {
  const auto digest = [] {
    Obeying robot;
    robot.ask(setMotion("look-left", headTurn("look-left", 45), 7));
    robot.playOnce("look-left", 1);
    return robot.run->world().digest();
  };
  EXPECT_EQ(digest(), digest());
}
