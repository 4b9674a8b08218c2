// SPDX-License-Identifier: GPL-3.0-or-later
// What a program publishes because it is recorded, whatever a person asked to see.
#include <gtest/gtest.h>

#include "robotlink/session/QueueMessages.h"
#include "tests/robotlink/debugging/ToyRobot.h"

using namespace robotlink;
using namespace robotlink::test;
using robotcontrol::KeyMode;
using robotcontrol::Request;

namespace {

Request recordPackages(const std::vector<std::string>& packages) {
  Request request;
  request.mutable_record_packages();
  for (const std::string& package : packages) request.mutable_record_packages()->add_packages(package);
  return request;
}

std::size_t onlyRecorded(const ToyRobot& robot, const std::string& path) {
  std::size_t count = 0;
  for (const auto* message : robot.on(path)) count += message->only_recorded() ? 1U : 0U;
  return count;
}

}  // namespace

TEST(RecordPackages, arePackagesOfAllProcessesUntilTheyAreAskedForNoMore) {
  ToyRobot robot;
  robot.run(20);
  EXPECT_TRUE(robot.on("percepts/ball").empty());
  EXPECT_TRUE(robot.ask(recordPackages({"percepts/ball", "motion/status"})).accepted());
  robot.run(20);
  EXPECT_FALSE(robot.on("percepts/ball").empty());
  EXPECT_FALSE(robot.on("motion/status").empty());
  EXPECT_TRUE(robot.on("models/ball").empty());
  EXPECT_EQ(onlyRecorded(robot, "percepts/ball"), robot.on("percepts/ball").size());
  EXPECT_TRUE(robot.ask(recordPackages({})).accepted());
  robot.run(20);
  robot.heard.clear();
  robot.run(20);
  EXPECT_TRUE(robot.on("percepts/ball").empty());
}

TEST(RecordPackages, leaveAPersonsKeysAlone) {
  ToyRobot robot;
  robot.setKey("package/percepts/ball", KeyMode::EVERY_N, 3);
  robot.ask(recordPackages({"percepts/ball"}));
  robot.run(10);
  robot.heard.clear();
  robot.run(90);  // 18 images
  EXPECT_NEAR(static_cast<double>(robot.on("percepts/ball").size()), 18, 1);
  EXPECT_NEAR(static_cast<double>(onlyRecorded(robot, "percepts/ball")), 12, 1);
  robot.ask(recordPackages({}));
  robot.run(10);
  robot.heard.clear();
  robot.run(90);
  EXPECT_NEAR(static_cast<double>(robot.on("percepts/ball").size()), 6, 1);
  EXPECT_EQ(onlyRecorded(robot, "percepts/ball"), 0U);
}

TEST(RecordPackages, canBeginWithTheFirstFrame) {
  ToyRobot robot;
  const auto yielded = robot.program->yieldedPackages();
  EXPECT_EQ(yielded, (std::vector<std::string>{"behavior/motion", "joints/request", "models/ball",
                                               "motion/status", "percepts/ball"}));
  robot.program->recordPackages({yielded.begin(), yielded.end()});
  robot.run(20);
  ASSERT_FALSE(robot.on("percepts/ball").empty());
  // Its object counts its images from 1.
  robotcontrol::BallPercept first;
  ASSERT_TRUE(first.ParseFromString(robot.on("percepts/ball").front()->package().data()));
  EXPECT_EQ(first.confidence(), 1);
}

TEST(RecordPackages, areLeftOutForViewsButNotForRecorders) {
  ToyRobot robot;
  robot.ask(recordPackages({"percepts/ball"}));
  robot.run(20);
  robotcontrol::DebugQueue wire;
  for (const auto& message : robot.heard) *wire.add_messages() = message;
  const auto queue = fromWire(wire);
  const auto count = [&](QueueReader reader) {
    const auto parts = messagesOf("red1", *queue, {}, reader);
    return std::count_if(parts.messages.begin(), parts.messages.end(),
                         [](const auto& message) { return message.path == "red1/percepts/ball"; });
  };
  EXPECT_EQ(count(QueueReader::kViews), 0);
  EXPECT_GT(count(QueueReader::kRecorder), 0);
}

TEST(RecordPackages, theParametersOfAllSolutionsAreKnownBeforeItRuns) {
  const ToyRobot robot;
  const auto parameters = robot.program->parameters();
  ASSERT_EQ(parameters.size(), 1U);
  EXPECT_EQ(parameters[0].task(), "ball-percept");
  EXPECT_EQ(parameters[0].solution(), "region");
  EXPECT_EQ(parameters[0].value().type(), "robotcontrol.Velocity2");
  EXPECT_FALSE(parameters[0].descriptors().empty());
}
