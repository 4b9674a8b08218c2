// SPDX-License-Identifier: GPL-3.0-or-later
// Solutions that run in the shadow of the active one of their task.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "robotlink/debugging/DebugRoutes.h"
#include "robotlink/debugging/program/RequestPreview.h"
#include "tests/robotlink/debugging/ToyRobot.h"

using namespace robotlink;
using namespace robotlink::test;
using robotcontrol::KeyMode;
using ::testing::HasSubstr;

namespace {

constexpr char kObeyKey[] = "shadow/behavior/obey";

/// All that a robot has published but what its shadows have, by path and time; the tables of keys list modes
/// of shadows.
std::vector<std::string> withoutShadows(const ToyRobot& robot) {
  std::vector<std::string> all;
  for (const auto& message : robot.heard) {
    if (message.path().starts_with("shadow/") || message.path().starts_with("tables/keys") ||
        message.path() == "results")
      continue;
    all.push_back(message.SerializeAsString());
  }
  return all;
}

const robotcontrol::KeyTable::Key* keyOf(const ToyRobot& robot, const std::string& name) {
  const auto tables = robot.on("tables/keys");
  if (tables.empty()) return nullptr;
  const auto& keys = tables.back()->keys().keys();
  const auto found = std::ranges::find(keys, name, [](const auto& key) { return key.name(); });
  return found == keys.end() ? nullptr : &*found;
}

std::string layoutWith(const std::string& shadow) {
  return std::string(kToyLayout) + "shadows: [" + shadow + "]\n";
}

TEST(ShadowTest, aKeyNamesTaskAndSolution) {
  EXPECT_EQ(shadowKey("ball-model", "kalman"), "shadow/ball-model/kalman");
  EXPECT_EQ(shadowOfKey("shadow/ball-model/kalman"), (ShadowName{"ball-model", "kalman"}));
  EXPECT_EQ(shadowOfKey("ball-model/kalman"), std::nullopt);
  EXPECT_EQ(shadowOfKey("shadow/kalman"), std::nullopt);
  EXPECT_EQ(shadowPrefix("kalman"), "shadow/kalman/");
}

TEST(ShadowTest, itPublishesUnderItsNameAndReachesNobody) {
  ToyRobot robot;
  robot.setKey("package/behavior/motion", KeyMode::ALWAYS);
  ASSERT_TRUE(robot.setKey(kObeyKey, KeyMode::ALWAYS).accepted());
  robot.run(100);
  const auto used = robot.on("behavior/motion"), shadowed = robot.on("shadow/obey/behavior/motion");
  ASSERT_GT(shadowed.size(), 10U);
  robotcontrol::MotionRequest request;
  ASSERT_TRUE(request.ParseFromString(used.back()->package().data()));
  EXPECT_GT(request.walk().x(), 0) << "the active solution goes";
  ASSERT_TRUE(request.ParseFromString(shadowed.back()->package().data()));
  EXPECT_EQ(request.walk().x(), 0) << "the shadow obeys nobody";
  EXPECT_EQ(robot.active("behavior"), "go");
}

TEST(ShadowTest, activeSolutionsSendTheSameBytesWithAndWithoutShadows) {
  ToyRobot plain, shadowed;
  for (ToyRobot* robot : {&plain, &shadowed}) {
    for (const char* key : {"package/percepts/ball", "package/models/ball", "package/behavior/motion"})
      robot->setKey(key, KeyMode::EVERY_N, 3);
    robot->setKey("ball-model/plot", KeyMode::EVERY_N, 2);
    robot->setKey("ball-percept/dot", KeyMode::N_TIMES, 7);
    const auto kind = robot == &shadowed ? KeyMode::ALWAYS : KeyMode::OFF;
    for (const char* key : {kObeyKey, "shadow/ball-model/last", "shadow/ball-percept/region"})
      EXPECT_TRUE(robot->setKey(key, kind).accepted());
    robot->run(100);
    EXPECT_TRUE(robot->select("behavior", "obey").accepted());
    robot->run(100);
  }
  EXPECT_EQ(plain.platform.requests(), shadowed.platform.requests());
  EXPECT_EQ(withoutShadows(plain), withoutShadows(shadowed));
  EXPECT_FALSE(shadowed.on("shadow/obey/behavior/motion").empty());
}

TEST(ShadowTest, itsKeysHaveCountersOfTheirOwn) {
  ToyRobot robot;
  ASSERT_TRUE(robot.setKey("shadow/ball-model/last", KeyMode::ALWAYS).accepted());
  robot.run(20);
  EXPECT_TRUE(robot.on("shadow/last/models/ball").empty()) << "it is the active solution itself";
  EXPECT_TRUE(robot.setKey("ball-model/plot", KeyMode::N_TIMES, 3).accepted());
  robot.run(60);
  EXPECT_EQ(robot.on("plots/ball-model/plot").size(), 3U);
  EXPECT_TRUE(robot.on("shadow/last/plots/ball-model/plot").empty());
}

TEST(ShadowTest, aModeLetsItRunLessOften) {
  ToyRobot robot;
  ASSERT_TRUE(robot.setKey(kObeyKey, KeyMode::EVERY_N, 4).accepted());
  robot.setKey("package/behavior/motion", KeyMode::ALWAYS);
  const auto before = robot.on("shadow/obey/behavior/motion").size();
  const auto usedBefore = robot.on("behavior/motion").size();
  robot.run(200);
  const auto used = robot.on("behavior/motion").size() - usedBefore;
  ASSERT_GT(used, 20U);
  EXPECT_NEAR(static_cast<double>(robot.on("shadow/obey/behavior/motion").size() - before),
              static_cast<double>(used) / 4, 1);
  ASSERT_TRUE(robot.setKey(kObeyKey, KeyMode::N_TIMES, 2).accepted());
  robot.run(100);
  ASSERT_NE(keyOf(robot, kObeyKey), nullptr);
  EXPECT_EQ(keyOf(robot, kObeyKey)->mode().kind(), KeyMode::OFF) << "it has ended by itself";
}

TEST(ShadowTest, oneThatThrowsIsSwitchedOffAndTheOthersGoOn) {
  ToyRobot robot;
  ASSERT_TRUE(robot.setKey("shadow/ball-model/throwing", KeyMode::ALWAYS).accepted());
  robot.run(50);
  EXPECT_TRUE(robot.failed.empty());
  EXPECT_EQ(livingSolutions(), 4) << "it is gone";
  EXPECT_EQ(keyOf(robot, "shadow/ball-model/throwing")->mode().kind(), KeyMode::OFF);
  const auto texts = robot.on("log");
  ASSERT_EQ(texts.size(), 1U);
  EXPECT_EQ(texts.back()->text().name(), "cognition/ball-model (throwing)");
  EXPECT_THAT(texts.back()->text().message(), HasSubstr("the ball has no covariance"));
}

TEST(ShadowTest, whatCannotRunIsRefusedWithItsReasonNowAndInAPause) {
  ToyRobot robot;
  robot.run(20);
  for (const auto& [key, why] :
       {std::pair{"shadow/ball-percept/broken", "no color table for red1"},
        {"shadow/ball-model/oracle", "oracle of ball-model is unavailable"},
        {"shadow/ball-model/kalman", "there is no debug key 'shadow/ball-model/kalman'"},
        {"shadow/registry/first", "there is no debug key"}}) {
    robotcontrol::Request request;
    request.mutable_set_key()->set_name(key);
    request.mutable_set_key()->mutable_mode()->set_kind(KeyMode::ALWAYS);
    const std::string inPause = RequestPreview(*robot.program).add(request);
    const auto result = robot.setKey(key, KeyMode::ALWAYS);
    EXPECT_FALSE(result.accepted());
    EXPECT_THAT(result.reason(), HasSubstr(why));
    EXPECT_EQ(result.reason(), inPause);
  }
}

TEST(ShadowTest, itsTimeIsMeasuredBesideThatOfTheActiveSolution) {
  ToyRobot robot;
  robot.setKey("timing/tasks", KeyMode::ALWAYS);
  robot.setKey(kObeyKey, KeyMode::ALWAYS);
  robot.run(50);
  const auto times = robot.on("stopwatches/cognition");
  ASSERT_FALSE(times.empty());
  std::vector<std::string> entries;
  for (const auto& entry : times.back()->stopwatches().entries())
    entries.push_back(entry.task() + " " + entry.solution());
  EXPECT_THAT(entries, ::testing::ElementsAre("ball-percept region", "ball-model last", "behavior go",
                                              "behavior obey (shadow)", " "));
}

TEST(ShadowTest, aLayoutStartsThemAndLeavesOutWhatCannotRun) {
  ToyRobot robot(layoutWith("behavior/obey, ball-model/oracle"));
  robot.run(50);
  EXPECT_FALSE(robot.on("shadow/obey/behavior/motion").empty());
  EXPECT_EQ(keyOf(robot, kObeyKey)->mode().kind(), KeyMode::ALWAYS);
  const auto texts = robot.on("log");
  ASSERT_EQ(texts.size(), 1U);
  EXPECT_THAT(texts.back()->text().message(), HasSubstr("no shadow: solution oracle of ball-model is"));
  EXPECT_TRUE(robot.setKey(kObeyKey, KeyMode::OFF).accepted());
  const Errors unknown = robot.load(layoutWith("behavior/sleep"));
  ASSERT_EQ(unknown.size(), 1U);
  EXPECT_EQ(unknown.front().id, "layout.unknown-solution");
  const Errors form = robot.load(layoutWith("behavior"));
  ASSERT_FALSE(form.empty());
  EXPECT_EQ(form.front().id, "layout.shadow-form");
}

}  // namespace
