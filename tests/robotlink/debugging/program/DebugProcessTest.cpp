// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/program/DebugProcess.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/robotlink/debugging/ToyRobot.h"

using namespace robotlink;
using namespace robotlink::test;
using robotcontrol::KeyMode;
using robotcontrol::Request;

namespace {

Request walk(double speed) {
  Request request;
  request.mutable_motion()->mutable_motion()->mutable_walk()->set_x(speed);
  return request;
}

TEST(DebugProcessTest, aRemoteMotionReachesTheSolutionThatObeys) {
  ToyRobot robot;
  EXPECT_TRUE(robot.select("behavior", "obey").accepted());
  EXPECT_TRUE(robot.ask(walk(0.25)).accepted());
  robot.run(20);
  robotcontrol::JointRequest request;
  request.ParseFromString(robot.platform.requests().back());
  EXPECT_EQ(0.25, request.positions(1));
}

TEST(DebugProcessTest, aRemoteMotionThatNobodyObeysIsRefused) {
  ToyRobot robot(R"(version: 1
name: eyes
processes:
  - {name: see, blocking: [camera/image], tasks: [ball-percept: region]}
  - {name: debug, debug: true, period_ms: 16}
)");
  EXPECT_EQ("no task of this layout obeys remote motions", robot.ask(walk(1)).reason());
}

/// Puts a request to the joints in place of what the task motion offers.
Request setJoints(robotcontrol::SetPackage::Mode mode) {
  Request request;
  auto& set = *request.mutable_set_package();
  set.set_package("joints/request");
  set.set_mode(mode);
  robotcontrol::JointRequest joints;
  joints.add_positions(4242);
  set.mutable_value()->set_type(joints.GetDescriptor()->full_name());
  set.mutable_value()->set_data(joints.SerializeAsString());
  return request;
}

int requestsOfTheUser(const ToyRobot& robot, std::size_t from) {
  int count = 0;
  for (std::size_t i = from; i < robot.platform.requests().size(); ++i) {
    robotcontrol::JointRequest joints;
    joints.ParseFromString(robot.platform.requests()[i]);
    count += joints.positions_size() > 0 && joints.positions(0) == 4242 ? 1 : 0;
  }
  return count;
}

std::set<std::string> heldIn(const robotcontrol::ProcessTable& table) {
  std::set<std::string> held;
  for (const auto& process : table.processes()) {
    for (const auto* ports : {&process.receivers(), &process.senders()}) {
      for (const auto& port : *ports) {
        if (port.held()) held.insert(process.name() + ":" + port.package());
      }
    }
  }
  return held;
}

TEST(DebugProcessTest, aPackageIsHeldUntilItIsReleasedAndTheTableOfProcessesSaysSo) {
  ToyRobot robot;
  robot.run(20);
  EXPECT_TRUE(robot.ask(setJoints(robotcontrol::SetPackage::HOLD)).accepted());
  robot.run(80);
  const std::size_t before = robot.platform.requests().size();
  robot.run(50);
  EXPECT_EQ(requestsOfTheUser(robot, before), static_cast<int>(robot.platform.requests().size() - before));
  EXPECT_EQ(heldIn(robot.on("tables/processes").back()->processes()),
            std::set<std::string>{"motion:joints/request"});
  EXPECT_TRUE(robot.ask(setJoints(robotcontrol::SetPackage::RELEASE)).accepted());
  robot.run(80);
  const std::size_t after = robot.platform.requests().size();
  robot.run(50);
  EXPECT_EQ(requestsOfTheUser(robot, after), 0);
  EXPECT_TRUE(heldIn(robot.on("tables/processes").back()->processes()).empty());
}

TEST(DebugProcessTest, aPackageIsSentOnce) {
  ToyRobot robot;
  robot.run(20);
  const std::size_t before = robot.platform.requests().size();
  EXPECT_TRUE(robot.ask(setJoints(robotcontrol::SetPackage::ONCE)).accepted());
  robot.run(50);
  EXPECT_EQ(requestsOfTheUser(robot, before), 1);
}

TEST(DebugProcessTest, aReadingIsHeldWhereItIsReceived) {
  ToyRobot robot;
  robot.setKey("package/joints/states", KeyMode::ALWAYS);
  Request request;
  auto& set = *request.mutable_set_package();
  set.set_package("joints/states");
  set.set_mode(robotcontrol::SetPackage::HOLD);
  foxglove::JointStates held;
  held.add_joints()->set_position(77);
  set.mutable_value()->set_type("foxglove.JointStates");
  set.mutable_value()->set_data(held.SerializeAsString());
  EXPECT_TRUE(robot.ask(request).accepted());
  robot.run(100);
  ASSERT_FALSE(robot.on("joints/states").empty());
  foxglove::JointStates shown;
  shown.ParseFromString(robot.on("joints/states").back()->package().data());
  EXPECT_EQ(shown.joints(0).position(), 77);
  EXPECT_GT(shown.timestamp().nanos() + shown.timestamp().seconds(), 0) << "as if it were read now";
  EXPECT_EQ(heldIn(robot.on("tables/processes").back()->processes()),
            std::set<std::string>{"motion:joints/states"});
}

TEST(DebugProcessTest, aPackageThatTheProgramDoesNotHaveOrOfAnotherTypeIsRefused) {
  ToyRobot robot;
  Request request;
  auto& set = *request.mutable_set_package();
  set.set_mode(robotcontrol::SetPackage::HOLD);
  set.set_package("models/bal");
  EXPECT_EQ("there is no package 'models/bal' that can be set; did you mean 'models/ball'?",
            robot.ask(request).reason());
  set.set_package("models/ball");
  set.mutable_value()->set_type("robotcontrol.RobotPose");
  EXPECT_EQ("package models/ball is a robotcontrol.BallModel, not a 'robotcontrol.RobotPose'",
            robot.ask(request).reason());
  set.mutable_value()->set_type("robotcontrol.BallModel");
  set.mutable_value()->set_data("\xff");
  EXPECT_EQ("the value of package models/ball is damaged", robot.ask(request).reason());
  set.set_package("range/laser");
  set.mutable_value()->set_type("foxglove.LaserScan");
  set.mutable_value()->clear_data();
  EXPECT_EQ("no process of this layout has 'range/laser'", robot.ask(request).reason());
}

TEST(DebugProcessTest, aColorTableThatNobodyUsesOrThatIsNoneIsRefused) {
  ToyRobot robot;
  Request request;
  auto& table = *request.mutable_set_color_table()->mutable_table();
  EXPECT_EQ("no task of this layout uses a color table", robot.ask(request).reason());
  table.set_cells("ten cells.");
  EXPECT_EQ("a color table has 262144 cells, this one has 10", robot.ask(request).reason());
  table.set_cells(std::string(262144, '\1'));
  EXPECT_EQ("cells of the color table have classes without a name", robot.ask(request).reason());
  table.add_class_names("orange");
  table.mutable_correction()->mutable_cb()->set_gain(std::nan(""));
  EXPECT_EQ("the color table's correction has values that are not numbers", robot.ask(request).reason());
}

TEST(DebugProcessTest, eachRequestIsAnsweredExactlyOnceHoweverManyThereAre) {
  ToyRobot robot;
  std::set<std::uint64_t> expected;
  for (std::uint64_t id = 1000; id < 1300; ++id) {
    Request request;
    request.set_id(id);
    switch (id % 4) {
      case 0:
        request.mutable_set_key()->set_name("package/models/ball");
        break;
      case 1:
        request.mutable_set_key()->set_name("ball-percept/dot");
        break;
      case 2:
        request.mutable_select_solution()->set_task("behavior");
        request.mutable_select_solution()->set_solution("go");
        break;
      default:
        request.mutable_stop()->set_engaged(true);
        break;
    }
    ASSERT_TRUE(robot.program->debugProcess().request(request));
    expected.insert(id);
    if (id % 7 == 0) robot.run(1);
  }
  robot.run(50);
  std::multiset<std::uint64_t> answered;
  for (const auto* message : robot.on("results")) answered.insert(message->result().id());
  EXPECT_EQ(expected.size(), answered.size());
  EXPECT_EQ(expected, std::set<std::uint64_t>(answered.begin(), answered.end()));
}

TEST(DebugProcessTest, tooManyRequestsAreDropped) {
  ToyRobot robot;
  int accepted = 0;
  for (int i = 0; i < 2000; ++i) accepted += robot.program->debugProcess().request(walk(1)) ? 1 : 0;
  EXPECT_EQ(1000, accepted);
}

TEST(DebugProcessTest, whatIsNotAProgramsBusinessIsRefused) {
  ToyRobot robot;
  Request stop;
  stop.mutable_stop()->set_engaged(true);
  EXPECT_EQ("a robot's program cannot do this; ask its platform or the simulation", robot.ask(stop).reason());
}

TEST(DebugProcessTest, tablesComeAtTheStartAndOnRequestAndOtherwiseOnlyOnChange) {
  ToyRobot robot;
  robot.run(60);
  const std::size_t keys = robot.on("tables/keys").size();
  const std::size_t solutions = robot.on("tables/solutions").size();
  EXPECT_GE(keys, 1U);
  EXPECT_GE(solutions, 1U);
  robot.run(200);
  EXPECT_EQ(keys, robot.on("tables/keys").size());
  Request request;
  request.mutable_send_tables();
  EXPECT_TRUE(robot.ask(request).accepted());
  robot.run(20);
  EXPECT_GT(robot.on("tables/keys").size(), keys);
  EXPECT_GT(robot.on("tables/solutions").size(), solutions);
}

TEST(DebugProcessTest, theProcessTableComesTwiceASecondWithAllEnds) {
  ToyRobot robot;
  robot.run(251);  // two seconds
  const auto tables = robot.on("tables/processes");
  EXPECT_EQ(4U, tables.size());
  const auto& table = tables.back()->processes();
  ASSERT_EQ(4, table.processes_size());
  const auto& cognition = table.processes(0);
  EXPECT_EQ("cognition", cognition.name());
  EXPECT_EQ("running", cognition.state());
  EXPECT_GT(cognition.frames(), 30U);
  EXPECT_EQ((std::vector<std::string>{"ball-percept", "ball-model", "behavior"}),
            std::vector<std::string>(cognition.tasks().begin(), cognition.tasks().end()));
  const auto& image = *std::find_if(cognition.receivers().begin(), cognition.receivers().end(),
                                    [](const auto& port) { return port.package() == "camera/image"; });
  EXPECT_EQ("foxglove.RawImage", image.type());
  EXPECT_TRUE(image.blocking());
  EXPECT_EQ("toy", image.peer());
  EXPECT_EQ(cognition.frames(), image.count());
  EXPECT_EQ("toy", table.processes(3).name());
}

TEST(DebugProcessTest, whatAFailedProcessNeverDidIsRefused) {
  ToyRobot robot;
  robot.platform.setImageEvery(1000);  // cognition waits, so its requests do
  robot.run(20);
  Request request;
  request.set_id(77);
  request.mutable_select_solution()->set_task("behavior");
  request.mutable_select_solution()->set_solution("obey");
  robot.program->debugProcess().request(request);
  robot.run(20);
  EXPECT_TRUE(robot.on("results").empty());
  robot.program->processes()[0]->stop();
  robot.run(10);
  const auto results = robot.on("results");
  ASSERT_EQ(1U, results.size());
  EXPECT_EQ(77U, results[0]->result().id());
  EXPECT_EQ("process cognition has stopped", results[0]->result().reason());
}

}  // namespace
