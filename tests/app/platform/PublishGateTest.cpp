// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/platform/PublishGate.h"

#include <gtest/gtest.h>

#include <thread>

#include "foxglove/Robot.pb.h"
#include "logplayer/file/LogFile.h"
#include "logplayer/record/Recorder.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/base/GroundMap.h"
#include "robotlink/session/Session.h"
#include "tests/TestFolder.h"

namespace app {
namespace {

using robotlink::Instant;

Instant instantAt(int milliseconds) {
  return Instant(std::chrono::milliseconds(milliseconds));
}

class PublishGateTest : public testing::Test {
 protected:
  PublishGateTest() { session.setRobots({"red1"}); }
  /// The texts that the session has, one after the other.
  std::string texts() {
    session.tick();
    std::string all;
    const auto* stream = session.store().find("red1/log");
    if (stream == nullptr) return all;
    for (const auto& message : stream->messages)
      all += dynamic_cast<const foxglove::Log&>(*message.value).message() + "|";
    return all;
  }
  void publish(const std::string& text, int time) {
    gate.publishText("red1", "test", instantAt(time), foxglove::Log::INFO, text);
  }

  robotlink::Session session;
  PublishGate gate{session};
};

TEST_F(PublishGateTest, whatIsPublishedBeforeItOpensComesInItsOrderWhenItDoes) {
  publish("first", 1);
  publish("second", 2);
  EXPECT_EQ(texts(), "");
  gate.open();
  EXPECT_EQ(texts(), "first|second|");
  publish("third", 3);
  EXPECT_EQ(texts(), "first|second|third|");
}

TEST_F(PublishGateTest, whatIsDiscardedNeverComes) {
  publish("of a run that failed", 1);
  gate.discard();
  gate.open();
  EXPECT_EQ(texts(), "");
  gate.close();
  publish("later", 2);
  EXPECT_EQ(texts(), "");
  gate.open();
  EXPECT_EQ(texts(), "later|");
}

TEST_F(PublishGateTest, openingTwicePublishesNothingTwice) {
  publish("once", 1);
  gate.open();
  gate.open();
  EXPECT_EQ(texts(), "once|");
}

TEST_F(PublishGateTest, whatDoesNotWorkOfAPlatformIsAWarning) {
  gate.open();
  gate.publishPlatform("red1", instantAt(1), "it was set up");
  gate.publishPlatformProblem("red1", instantAt(2), "no such device");
  EXPECT_EQ(texts(), "it was set up|no such device|");
  const auto& all = session.store().find("red1/log")->messages;
  EXPECT_EQ(dynamic_cast<const foxglove::Log&>(*all.front().value).level(), foxglove::Log::INFO);
  EXPECT_EQ(dynamic_cast<const foxglove::Log&>(*all.back().value).level(), foxglove::Log::WARNING);
}

TEST_F(PublishGateTest, notesOfAMapAreWarningsWhereItIsIncomplete) {
  robotlink::GroundMap map;
  map.notes = {"a line is missing"};
  map.incomplete = true;
  gate.open();
  gate.publishMapNotes("red1", instantAt(1), map);
  session.tick();
  const auto* entry = session.store().latestAs<foxglove::Log>("red1/log", instantAt(2));
  ASSERT_NE(entry, nullptr);
  EXPECT_EQ(entry->level(), foxglove::Log::WARNING);
  EXPECT_EQ(entry->name(), "map");
  EXPECT_EQ(entry->message(), "a line is missing");
}

TEST_F(PublishGateTest, fromAnyThreadAllOfItComes) {
  constexpr int kTexts = 50;
  const std::vector<std::string> robots{"red1", "red2", "blue1", "blue2"};
  session.setRobots(robots);
  std::vector<std::thread> threads;
  for (const std::string& robot : robots) {
    threads.emplace_back([this, robot] {
      for (int i = 1; i <= kTexts; ++i)
        gate.publishText(robot, "test", instantAt(i), foxglove::Log::INFO, std::to_string(i));
    });
  }
  gate.open();
  for (std::thread& thread : threads) thread.join();
  session.tick();
  for (const std::string& robot : robots) {
    const auto* stream = session.store().find(robot + "/log");
    ASSERT_NE(stream, nullptr) << robot;
    EXPECT_EQ(stream->messages.size(), static_cast<std::size_t>(kTexts)) << robot;
  }
}

TEST(RecordedPublishGate, whatItKeptBackIsRecordedToo) {
  const TestFolder folder;
  robotlink::Session session;
  logplayer::Recorder recorder({});
  robotcontrol::ControlRecording control;
  control.set_action(robotcontrol::ControlRecording::START);
  control.set_path((folder / "log.mcap").string());
  ASSERT_TRUE(recorder.control(control));
  PublishGate gate(session, &recorder);
  gate.open();
  for (int i = 1; i <= 3; ++i)
    gate.publishText("red1", "test", instantAt(i), foxglove::Log::INFO, "text " + std::to_string(i));
  control.set_action(robotcontrol::ControlRecording::STOP);
  ASSERT_TRUE(recorder.control(control));
  recorder.finish();
  const auto log = logplayer::LogFile::open(folder / "log.mcap", {});
  ASSERT_TRUE(log) << log.error().describe();
  std::uint64_t count = 0;
  for (const auto& stream : (*log)->streams()) count += stream.path == "red1/log" ? stream.count : 0;
  EXPECT_EQ(count, 3U);
}

}  // namespace
}  // namespace app
