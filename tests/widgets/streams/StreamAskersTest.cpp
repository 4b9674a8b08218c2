// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/streams/StreamAskers.h"

#include <gtest/gtest.h>

#include "robotcontrol/Linking.pb.h"
#include "robotcontrol/Logging.pb.h"
#include "robotlink/session/Session.h"
#include "tests/widgets/streams/StoredMessages.h"

namespace widgets::test {
namespace {

/// A robot whose debug keys publish some of its streams.
class StreamAskersTest : public testing::Test {
 protected:
  StreamAskersTest() {
    session.setRobots({"red1"});
    addKey("ball", "plots/ball", robotcontrol::KeyMode::EVERY_MS, 100);
    addKey("ball/age", "plots/ball/age", robotcontrol::KeyMode::ALWAYS);
    addKey("silent", "", robotcontrol::KeyMode::ALWAYS);
    push("red1/tables/keys", keys);
  }
  template <typename T>
  void push(const std::string& path, const T& message) {
    session.push({path, atSeconds(1), std::make_shared<const T>(message)});
    session.tick();
  }
  void addKey(const char* name, const char* stream, robotcontrol::KeyMode::Kind kind, unsigned n = 0) {
    auto& key = *keys.add_keys();
    key.set_name(name);
    key.set_stream(stream);
    key.mutable_mode()->set_kind(kind);
    key.mutable_mode()->set_n(n);
  }
  StreamAsked asked(const char* path) {
    push(path, robotcontrol::PlotValue());
    return StreamAskers(session).of(*session.store().find(path));
  }

  robotlink::Session session;
  robotcontrol::KeyTable keys;
};

TEST_F(StreamAskersTest, aStreamHasTheKeyOfItsPathOrOfTheNearestOneAbove) {
  EXPECT_EQ(asked("red1/plots/ball/age").key.toStdString(), "ball/age: always");
  EXPECT_EQ(asked("red1/plots/ball/age/mean").key.toStdString(), "ball/age: always");
  EXPECT_EQ(asked("red1/plots/ball/x").key.toStdString(), "ball: every n ms (100 ms)");
}

TEST_F(StreamAskersTest, namesThatOnlyBeginAlikeAreOthers) {
  EXPECT_TRUE(asked("red1/plots/balls").key.isEmpty());
  EXPECT_TRUE(asked("blue1/plots/ball").key.isEmpty());
  EXPECT_TRUE(asked("simulation").key.isEmpty());
}

TEST_F(StreamAskersTest, clientsThatSubscribeToTheKeyAreNamed) {
  robotcontrol::KeySubscribers subscribers;
  auto& key = *subscribers.add_keys();
  key.set_name("ball");
  for (const char* client : {"Foxglove", "RobotControl"}) key.add_clients(client);
  push("red1/tables/subscribers", subscribers);
  EXPECT_EQ(asked("red1/plots/ball/x").clients,
            (QStringList{QStringLiteral("Foxglove"), QStringLiteral("RobotControl")}));
  EXPECT_FALSE(asked("red1/plots/ball/age").isRead()) << "that has a key of its own";
}

TEST_F(StreamAskersTest, aRecordingIsAmongTheReadersWhileItRuns) {
  robotcontrol::RecordingStatus status;
  push("recording", status);
  EXPECT_FALSE(asked("red1/plots/ball/x").isRead());
  status.set_recording(true);
  status.mutable_selection()->add_exclude("red1/plots/other");
  push("recording", status);
  EXPECT_EQ(asked("red1/plots/ball/x").views, QStringList(QStringLiteral("Recording")));
  EXPECT_FALSE(asked("red1/plots/other").isRead());
}

TEST_F(StreamAskersTest, viewsAreNamedThatReadTheStreamWhileTheyWereUpdated) {
  push("red1/plots/ball/x", robotcontrol::PlotValue());
  {
    const robotlink::StreamReaders::Scope scope(session.readers(), "plots-1", "Plots");
    (void)session.store().find("red1/plots/ball/x");
  }
  const auto& stream = *session.store().find("red1/plots/ball/x");
  EXPECT_EQ(StreamAskers(session).of(stream).views, QStringList(QStringLiteral("Plots")));
}

}  // namespace
}  // namespace widgets::test
