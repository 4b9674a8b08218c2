// SPDX-License-Identifier: GPL-3.0-or-later
// A session whose platform starts over: a jump in a log, another scene.
#include <gmock/gmock.h>

#include <atomic>
#include <thread>

#include "robotcontrol/Requests.pb.h"
#include "robotlink/session/Session.h"
#include "tests/robotlink/session/SessionMessages.h"

using namespace robotlink;
using namespace robotlink::test;
using testing::ElementsAre;

TEST(Session, aRestartForgetsWhatWasPublishedBeforeAndGoesLive) {
  Session session;
  session.push(plot("a", 5));
  session.tick();
  session.timeline().show(at(1));
  session.push(plot("waits", 6));
  session.restart();
  session.push(plot("b", 2));
  EXPECT_NE(session.store().find("a"), nullptr) << "only the tick changes the history";
  session.tick();
  EXPECT_EQ(session.store().streams().size(), 1U);
  EXPECT_NE(session.store().latest("b", at(2)), nullptr);
  EXPECT_TRUE(session.timeline().live());
  EXPECT_EQ(session.timeline().shown(), at(2));
  session.push(plot("b", 3));
  session.tick();
  EXPECT_EQ(session.store().find("b")->messages.size(), 2U) << "it is forgotten once";
}

TEST(Session, aRestartThatPublishesNothingEmptiesTheHistory) {
  Session session;
  session.push(plot("a", 5));
  session.tick();
  session.restart();
  session.tick();
  EXPECT_TRUE(session.store().streams().empty());
  EXPECT_EQ(session.timeline().newest(), Instant{});
}

TEST(Session, whatARestartPublishesAppearsAsAWhole) {
  Session session;
  session.push(plot("old", 5));
  session.tick();
  session.restart([&] {
    session.push(plot("a", 1));
    session.tick();
    EXPECT_NE(session.store().find("old"), nullptr) << "until all is published, the old history stays";
    EXPECT_EQ(session.store().find("a"), nullptr);
    session.push(plot("b", 2));
  });
  session.tick();
  EXPECT_EQ(session.store().find("old"), nullptr);
  EXPECT_NE(session.store().find("a"), nullptr);
  EXPECT_NE(session.store().find("b"), nullptr);
}

TEST(Session, anAnswerComesWithWhatARestartPublishes) {
  Session session;
  session.setRequestSink([](const robotcontrol::Request&) {});
  int answers = 0;
  robotcontrol::RequestResult result;
  result.set_id(session.request({}, [&](const auto&) {
    ++answers;
    EXPECT_NE(session.store().find("a"), nullptr);
  }));
  session.pushResult(result);
  session.restart([&] {
    session.tick();
    EXPECT_EQ(answers, 0);
    session.push(plot("a", 1));
  });
  session.tick();
  EXPECT_EQ(answers, 1);
}

TEST(Session, whatBelongsTogetherIsKeptOrDroppedAsAWhole) {
  Session session({}, {.messages = 5, .bytes = 1U << 20U});
  for (int i = 1; i <= 3; ++i) session.push({plot("a", i), plot("b", i), {"no-value", at(i), nullptr}});
  session.push(std::vector<StreamMessage>{});
  EXPECT_EQ(session.dropped(), 2U);
  session.tick();
  EXPECT_EQ(session.store().find("a")->messages.front().time, at(2));
  EXPECT_EQ(session.store().find("b")->messages.front().time, at(2));
  EXPECT_EQ(session.store().find("no-value"), nullptr);
}

TEST(Session, aHistoryOfAnyLengthStaysWithinItsBoundsOverRestarts) {
  constexpr std::size_t kBytes = 100'000;
  Session session({.age = std::chrono::seconds(1000), .bytes = kBytes}, {});
  for (int round = 0; round < 5; ++round) {
    session.restart();
    for (int i = 0; i < 200; ++i) {
      session.push({plot("a", i, 1000), plot("b", i, 1000)});
      session.tick();
      ASSERT_LE(session.store().bytes(), kBytes);
    }
  }
  EXPECT_GT(session.store().find("a")->messages.size(), 30U);
}

TEST(Session, restartsMayComeFromAnotherThreadThanTheTick) {
  Session session;
  std::atomic<bool> done = false;
  std::thread producer([&] {
    for (int round = 0; round < 200; ++round) {
      session.restart([&] {
        for (const char* path : {"a", "b", "c"}) session.push(plot(path, round));
      });
    }
    done = true;
  });
  const auto look = [&] {
    session.tick();
    const auto& store = session.store();
    ASSERT_TRUE(store.streams().empty() || store.streams().size() == 3U);
  };
  while (!done) look();
  producer.join();
  look();
  EXPECT_EQ(session.store().newest(), at(199));
}
