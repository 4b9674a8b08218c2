// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/program/RobotProgram.h"

#include <gmock/gmock.h>

#include "robotlink/process/ThreadExecutor.h"
#include "tests/robotlink/debugging/ToyRobot.h"

using namespace robotlink;
using namespace robotlink::test;
using namespace std::chrono_literals;
using robotcontrol::KeyMode;

namespace {

robotcontrol::JointRequest lastRequest(const ToyPlatform& platform) {
  robotcontrol::JointRequest request;
  if (!platform.requests().empty()) request.ParseFromString(platform.requests().back());
  return request;
}

TEST(RobotProgramTest, sensorsReachTheActuatorsThroughAllTasks) {
  ToyRobot robot;
  robot.run(40);
  const auto request = lastRequest(robot.platform);
  ASSERT_EQ(2, request.positions_size());
  EXPECT_EQ(39, request.positions(0));  // the joint state of the last step but one
  EXPECT_EQ(35, request.positions(1));  // the image of step 35
  EXPECT_TRUE(robot.failed.empty());
}

TEST(RobotProgramTest, theSameInputsGiveTheSameBytes) {
  ToyRobot a;
  ToyRobot b;
  a.run(1000);
  b.run(1000);
  EXPECT_EQ(a.platform.requests(), b.platform.requests());
  ASSERT_EQ(a.heard.size(), b.heard.size());
  for (std::size_t i = 0; i < a.heard.size(); ++i) {
    ASSERT_EQ(a.heard[i].SerializeAsString(), b.heard[i].SerializeAsString()) << a.heard[i].path();
  }
}

TEST(RobotProgramTest, noFrameIsLostOnItsWayThroughTheDebugQueues) {
  ToyRobot robot;
  robot.run(500);
  const auto frames = robot.on("frames/motion");
  ASSERT_GT(frames.size(), 490U);
  for (std::size_t i = 0; i < frames.size(); ++i) ASSERT_EQ(i + 1, frames[i]->frame().number());
}

TEST(RobotProgramTest, aRefusedLayoutLeavesTheOldOneRunning) {
  ToyRobot robot;
  robot.run(20);
  const Errors errors =
      robot.load("version: 1\nname: x\nprocesses:\n  - {name: a, period_ms: 8, tasks: [{motion: crawl}]}\n");
  ASSERT_EQ(2U, errors.size()) << describe(errors);
  EXPECT_EQ("toy.yaml:4:37: task motion has no solution 'crawl'; there is walk", errors[1].describe());
  const std::size_t before = robot.platform.requests().size();
  robot.run(20);
  EXPECT_EQ(before + 20, robot.platform.requests().size());
  EXPECT_EQ(39, lastRequest(robot.platform).positions(0));
}

TEST(RobotProgramTest, anotherLayoutTakesThePlatformOver) {
  ToyRobot robot;
  robot.run(20);
  ASSERT_TRUE(robot.load(kToyLayout).empty());
  robot.run(20);
  EXPECT_EQ(39, lastRequest(robot.platform).positions(0));
  EXPECT_EQ(35, lastRequest(robot.platform).positions(1));
}

TEST(RobotProgramTest, theFirstTablesAreThoseOfAllProcesses) {
  ToyRobot robot;
  robot.platform.setImageEvery(50);  // cognition runs late, and reports late
  robot.run(5);
  const auto solutions = robot.on("tables/solutions");
  ASSERT_FALSE(solutions.empty());
  std::vector<std::string> tasks;
  for (const auto& task : solutions.front()->solutions().tasks()) tasks.push_back(task.name());
  EXPECT_THAT(tasks, testing::UnorderedElementsAre("ball-percept", "ball-model", "behavior", "motion"));
  ASSERT_FALSE(robot.on("tables/keys").empty());
}

TEST(RobotProgramTest, allObjectsAreDestroyedWithTheProgram) {
  {
    ToyRobot robot;
    robot.run(10);
    EXPECT_EQ(4, livingSolutions());
  }
  EXPECT_EQ(0, livingSolutions());
}

TEST(RobotProgramTest, aProcessThatThrowsStopsAloneAndSaysWhy) {
  ToyRobot robot;
  robot.run(10);
  ASSERT_TRUE(robot.select("ball-model", "throwing").accepted());
  robot.run(40);
  ASSERT_EQ(1U, robot.failed.size());
  EXPECT_EQ("cognition: ball-model (throwing): the ball has no covariance", robot.failed[0]);
  const auto log = robot.on("log");
  ASSERT_EQ(1U, log.size());
  EXPECT_EQ("process cognition has failed: ball-model (throwing): the ball has no covariance",
            log[0]->text().message());
  const auto before = robot.platform.requests().size();
  robot.run(10);
  EXPECT_EQ(before + 10, robot.platform.requests().size());  // motion goes on
  EXPECT_EQ("process cognition has failed: ball-model (throwing): the ball has no covariance",
            robot.select("ball-model", "last").reason());
}

TEST(RobotProgramTest, aBlockingOutputOfTheLayoutHoldsItsProcess) {
  std::string layout = kToyLayout;
  const std::string input = "    blocking: [camera/image]\n";
  layout.replace(layout.find(input), input.size(), input + "    blocking_outputs: [behavior/motion]\n");
  ToyRobot robot(layout);
  const Process& cognition = *robot.program->processes()[0];
  for (const AnySender* sender : cognition.senders())
    EXPECT_EQ(sender->package() == "behavior/motion", sender->blocking()) << sender->package();
  robot.run(100);
  EXPECT_EQ(19U, cognition.frames()) << "motion takes what it is sent in each of its frames";
  // Nobody takes what is sent any more: one package is delivered, one waits.
  robot.executor.clear();
  robot.executor.add(*robot.program->processes()[0]);
  robot.executor.add(robot.platform);
  robot.run(100);
  EXPECT_EQ(21U, cognition.frames());
  EXPECT_EQ("its package behavior/motion to be taken", cognition.waitsFor());
}

TEST(RobotProgramTest, runsInThreadsAndCanBeStoppedAtAnyTime) {
  ManualClock steps;
  ToyPlatform platform("toy", steps);
  auto layout = parseLayout(kToyLayout, "toy.yaml");
  ASSERT_TRUE(layout);
  RobotSetup setup;
  setup.name = "red1";
  for (int round = 0; round < 5; ++round) {
    auto program = RobotProgram::create(setup, *layout, platform, {});
    ASSERT_TRUE(program);
    std::atomic<int> queues{0};
    (*program)->debugProcess().setListener([&](const auto&) { ++queues; });
    ThreadExecutor executor({});
    for (Process* process : (*program)->processes()) executor.add(*process);
    executor.start();
    const auto deadline = std::chrono::steady_clock::now() + 20s;
    const auto heard = [&] { return queues > 0 && !platform.requests().empty(); };
    for (int i = 0; i < 50 || (!heard() && std::chrono::steady_clock::now() < deadline); ++i) {
      platform.tryBeginFrame();
      platform.actuate();
      steps.advance(8ms);
      executor.clockAdvanced();
      platform.runFrame();
      std::this_thread::yield();
    }
    if (round % 2 == 0) (*program)->stop();
    executor.stop();
    EXPECT_GT(queues, 0);
  }
  EXPECT_EQ(0, livingSolutions());
  EXPECT_FALSE(platform.requests().empty());
}

}  // namespace
