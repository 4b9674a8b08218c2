// SPDX-License-Identifier: GPL-3.0-or-later
// What a platform makes only while somebody wants it.
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "robotlink/packages/Conversions.h"
#include "robotlink/process/ThreadExecutor.h"
#include "tests/robotlink/debugging/ToyRobot.h"

using namespace robotlink;
using namespace robotlink::test;
using robotcontrol::KeyMode;

namespace {

constexpr char kKey[] = "package/oracle/classes";
constexpr char kPath[] = "oracle/classes";

/// Looked up in the newest table; null if there is none.
const robotcontrol::KeyTable::Key* keyIn(const ToyRobot& robot) {
  const auto tables = robot.on("tables/keys");
  if (tables.empty()) return nullptr;
  for (const auto& key : tables.back()->keys().keys()) {
    if (key.name() == kKey) return &key;
  }
  return nullptr;
}

}  // namespace

TEST(RequestedPackages, areNeitherMadeNorPublishedWhileTheirKeyIsOff) {
  ToyRobot robot;
  robot.run(50);
  EXPECT_EQ(robot.platform.classesMade(), 0);
  EXPECT_TRUE(robot.on(kPath).empty());
  ASSERT_NE(keyIn(robot), nullptr) << "but they are listed";
  EXPECT_EQ(keyIn(robot)->mode().kind(), KeyMode::OFF);
}

TEST(RequestedPackages, arePublishedWithTheirOwnTimesWhileTheirKeyIsOn) {
  ToyRobot robot;
  ASSERT_TRUE(robot.setKey(kKey, KeyMode::ALWAYS).accepted());
  robot.run(50);
  EXPECT_EQ(keyIn(robot)->mode().kind(), KeyMode::ALWAYS);
  const auto published = robot.on(kPath);
  EXPECT_NEAR(static_cast<double>(published.size()), 10, 1);
  for (const auto* message : published)
    EXPECT_EQ(instant(message->timestamp()), instant(message->image().timestamp()));
  ASSERT_TRUE(robot.setKey(kKey, KeyMode::OFF).accepted());
  robot.run(10);
  const int made = robot.platform.classesMade();
  robot.run(50);
  EXPECT_EQ(robot.platform.classesMade(), made);
  EXPECT_EQ(keyIn(robot)->mode().kind(), KeyMode::OFF);
}

TEST(RequestedPackages, areNoLongerMadeWhenTheirKeyHasRunOut) {
  ToyRobot robot;
  ASSERT_TRUE(robot.setKey(kKey, KeyMode::N_TIMES, 3).accepted());
  robot.run(60);
  EXPECT_EQ(robot.on(kPath).size(), 3U);
  EXPECT_EQ(robot.platform.classesMade(), 3);
  EXPECT_EQ(keyIn(robot)->mode().kind(), KeyMode::OFF);
}

TEST(RequestedPackages, keysOfOtherPackagesAreStillRefused) {
  ToyRobot robot;
  EXPECT_EQ(robot.setKey("package/oracle/nothing", KeyMode::ALWAYS).reason(),
            "no process of this layout has 'package/oracle/nothing'");
}

TEST(RequestedPackages, mayBeAskedForWhileEveryProcessHasItsThread) {
  ManualClock steps;
  ToyPlatform platform("toy", steps);
  auto layout = parseLayout(kToyLayout, "toy.yaml");
  ASSERT_TRUE(layout);
  RobotSetup setup;
  setup.name = "red1";
  auto program = RobotProgram::create(setup, *layout, platform, {});
  ASSERT_TRUE(program);
  std::atomic<int> published{0};
  (*program)->debugProcess().setListener([&](const auto& queue) {
    for (const auto& message : queue->messages) published += message.path == kPath ? 1 : 0;
  });
  ThreadExecutor executor({});
  for (Process* process : (*program)->processes()) executor.add(*process);
  executor.start();
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  robotcontrol::Request request;
  request.mutable_set_key()->set_name(kKey);
  for (int i = 0; i < 200 || (published == 0 && std::chrono::steady_clock::now() < deadline); ++i) {
    if (i % 20 == 0) {
      request.mutable_set_key()->mutable_mode()->set_kind(i % 40 == 0 ? KeyMode::ALWAYS : KeyMode::OFF);
      (*program)->debugProcess().request(request);
    }
    platform.tryBeginFrame();
    platform.actuate();
    steps.advance(std::chrono::milliseconds(8));
    executor.clockAdvanced();
    platform.runFrame();
    std::this_thread::yield();
  }
  (*program)->stop();
  executor.stop();
  EXPECT_GT(published, 0);
}

TEST(RequestedPackages, theNextProgramOnThePlatformStartsWithoutThem) {
  ToyRobot robot;
  ASSERT_TRUE(robot.setKey(kKey, KeyMode::ALWAYS).accepted());
  robot.run(20);
  ASSERT_TRUE(robot.load(kToyLayout).empty());
  const int made = robot.platform.classesMade();
  robot.run(50);
  EXPECT_EQ(robot.platform.classesMade(), made);
}
