// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/TypedStreams.h"

#include <gtest/gtest.h>

#include "foxglove/Robot.pb.h"
#include "robotcontrol/Driving.pb.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/session/Session.h"

namespace widgets {
namespace {

using namespace std::chrono_literals;
using robotlink::Instant;

class TypedStreamsTest : public testing::Test {
 protected:
  void say(const std::string& path, std::chrono::milliseconds time, const std::string& text,
           const std::string& process = {}) {
    auto message = std::make_shared<foxglove::Log>();
    message->set_message(text);
    session_.push({path, Instant(time), std::move(message), process});
    session_.tick();
  }
  /// The texts of what is new, separated by spaces; "restarted" comes first if the clock went back.
  std::string news(const std::string& path = "red1/log") {
    const auto* stream = session_.store().find(path);
    if (stream == nullptr) return "no stream";
    const auto taken = cursor_.take(*stream);
    std::string texts = taken.restarted ? "restarted" : "";
    for (const auto* message : taken.messages)
      texts += (texts.empty() ? "" : " ") + dynamic_cast<const foxglove::Log&>(*message->value).message();
    return texts;
  }
  std::vector<std::string> pathsOf(const std::string& robot, const char* type) {
    std::vector<std::string> paths;
    for (const auto* stream : streamsOfType(session_.store(), robot, type)) paths.push_back(stream->path);
    return paths;
  }

  robotlink::Session session_;
  StreamCursor cursor_;
};

TEST_F(TypedStreamsTest, streamsAreFoundByTypeAndRobot) {
  say("red1/log", 1ms, "a");
  say("red10/log", 1ms, "b");
  session_.push({"red1/drive/state", Instant(1ms), std::make_shared<robotcontrol::DriveState>()});
  session_.tick();
  EXPECT_EQ(pathsOf("red1", "foxglove.Log"), std::vector<std::string>{"red1/log"});
  EXPECT_EQ(pathsOf("", "foxglove.Log"), (std::vector<std::string>{"red1/log", "red10/log"}));
  EXPECT_EQ(pathsOf("red1", "robotcontrol.DriveState"), std::vector<std::string>{"red1/drive/state"});
  EXPECT_TRUE(pathsOf("red2", "foxglove.Log").empty());
}

TEST_F(TypedStreamsTest, theNewestMessagesAreThoseAtATime) {
  say("red1/log", 10ms, "early");
  say("red1/notes", 20ms, "late");
  const auto at = [&](std::chrono::milliseconds time) {
    return latestOfType(session_.store(), "red1", "foxglove.Log", Instant(time));
  };
  ASSERT_EQ(at(15ms).size(), 2U);
  EXPECT_EQ(at(15ms)[1], nullptr) << "it began later";
  EXPECT_NE(at(20ms)[1], nullptr);
  EXPECT_EQ(valuesOf(at(15ms))[1], nullptr);
  EXPECT_EQ(valuesOf(at(20ms)), valuesOf(at(30ms))) << "nothing changed";
  EXPECT_NE(valuesOf(at(15ms)), valuesOf(at(20ms)));
}

TEST_F(TypedStreamsTest, aTableIsThatOfItsRobot) {
  say("red1/tables/keys", 10ms, "keys");
  EXPECT_EQ(latestTable(session_.store(), "red1", "tables/keys", Instant(10ms)).size(), 1U);
  EXPECT_TRUE(latestTable(session_.store(), "red1", "tables/keys", Instant(9ms)).empty());
  EXPECT_TRUE(latestTable(session_.store(), "blue1", "tables/keys", Instant(10ms)).empty());
}

TEST_F(TypedStreamsTest, pathsHaveARobotAndALastPart) {
  EXPECT_EQ(robotlink::streams::robotOf("red1/stopwatches/cognition"), "red1");
  EXPECT_EQ(lastPart("red1/stopwatches/cognition"), "cognition");
  EXPECT_EQ(robotlink::streams::robotOf("scene"), "");
  EXPECT_EQ(lastPart("scene"), "scene");
}

TEST_F(TypedStreamsTest, logsOfOtherProgramsHaveForeignStreams) {
  say("map", 1s, "of our world");
  say("red1/log", 1s, "of our robot");
  EXPECT_FALSE(hasForeignStreams(session_.store()));
  say("/rosout", 1s, "of ROS");
  EXPECT_TRUE(hasForeignStreams(session_.store()));
}

TEST_F(TypedStreamsTest, aCursorReturnsEachMessageOnce) {
  say("red1/log", 10ms, "a");
  say("red1/log", 20ms, "b");
  EXPECT_EQ(news(), "a b");
  EXPECT_EQ(news(), "");
  say("red1/log", 30ms, "c");
  EXPECT_EQ(news(), "c");
}

TEST_F(TypedStreamsTest, aMessageThatArrivesLateIsNewToo) {
  say("red1/log", 10ms, "a");
  say("red1/log", 30ms, "c");
  EXPECT_EQ(news(), "a c");
  // Only messages of one process are in order.
  say("red1/log", 20ms, "b", "motion");
  EXPECT_EQ(news(), "b");
  EXPECT_EQ(news(), "");
}

TEST_F(TypedStreamsTest, messagesAtOneTimeAreAllReturned) {
  say("red1/log", 10ms, "a");
  EXPECT_EQ(news(), "a");
  say("red1/log", 10ms, "b");
  say("red1/log", 10ms, "c");
  EXPECT_EQ(news(), "b c");
}

TEST_F(TypedStreamsTest, aCursorStartsOverWhenTheSessionDoes) {
  say("red1/log", 1000ms, "a");
  EXPECT_EQ(news(), "a");
  session_.restart();
  say("red1/log", 10ms, "b");
  EXPECT_EQ(news(), "restarted b");
  EXPECT_EQ(news(), "");
}

}  // namespace
}  // namespace widgets
