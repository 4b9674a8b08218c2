// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/session/StreamStore.h"

#include <gtest/gtest.h>

#include "robotcontrol/Debugging.pb.h"

using namespace robotlink;
using namespace std::chrono_literals;
using robotcontrol::KeyTable;
using robotcontrol::PlotValue;

namespace {

Instant timeAt(double time) {
  return Instant(fromSeconds(time));
}

StreamMessage plotted(const std::string& path, double time, double value = 0) {
  auto message = std::make_shared<PlotValue>();
  message->set_value(value);
  return {path, timeAt(time), message};
}

StreamMessage large(const std::string& path, double time, std::size_t bytes) {
  auto message = std::make_shared<PlotValue>();
  message->set_unit(std::string(bytes, 'x'));
  return {path, timeAt(time), message};
}

double valueAt(const StreamStore& store, const std::string& path, double time) {
  const auto* value = store.latestAs<PlotValue>(path, timeAt(time));
  return value ? value->value() : -1;
}

}  // namespace

TEST(StreamStore, theNewestMessageNotLaterThanATimeIsFound) {
  StreamStore store({});
  for (int i = 1; i <= 100; ++i) store.add(plotted("a", i * 0.1, i));
  EXPECT_EQ(valueAt(store, "a", 0.05), -1);
  EXPECT_EQ(valueAt(store, "a", 0.1), 1);
  EXPECT_EQ(valueAt(store, "a", 5.05), 50);
  EXPECT_EQ(valueAt(store, "a", 1000), 100);
  EXPECT_EQ(store.latest("b", timeAt(1)), nullptr);
  EXPECT_EQ(store.latestAs<KeyTable>("a", timeAt(5)), nullptr) << "it is of another type";
}

TEST(StreamStore, messagesAreSharedNotCopied) {
  StreamStore store({});
  const StreamMessage message = plotted("a", 1);
  store.add(message);
  EXPECT_EQ(store.latest("a", timeAt(1))->value.get(), message.value.get());
}

TEST(StreamStore, whatIsTooOldIsForgottenButTheNewestOfEachStream) {
  StreamStore store({.age = 2s});
  store.add(plotted("rare", 0, 7));
  for (int i = 0; i <= 100; ++i) store.add(plotted("often", i * 0.1, i));
  EXPECT_EQ(valueAt(store, "rare", 10), 7);
  EXPECT_GE(store.find("often")->messages.front().time, timeAt(7.9));
  EXPECT_LE(store.find("often")->messages.front().time, timeAt(8.1));
  EXPECT_EQ(store.find("often")->count, 101U);
}

TEST(StreamStore, theHistoryIsBoundedInBytesOldestFirst) {
  StreamStore store({.bytes = 100'000});
  store.add(plotted("table", 0, 7));
  for (int i = 1; i <= 100; ++i) store.add(large(i % 2 == 0 ? "a" : "b", i, 9'000));
  EXPECT_LE(store.bytes(), 100'000U);
  EXPECT_GE(store.bytes(), 80'000U);
  EXPECT_EQ(valueAt(store, "table", 200), 7);
  EXPECT_GE(store.find("a")->messages.front().time, timeAt(88));
  EXPECT_EQ(store.find("a")->bytes + store.find("b")->bytes + store.find("table")->bytes, store.bytes());
  store.add(large("c", 101, 200'000));
  EXPECT_EQ(store.find("a")->messages.size(), 1U)
      << "one that is larger than the bound is kept as the newest";
  EXPECT_NE(store.latest("c", timeAt(101)), nullptr);
}

TEST(StreamStore, timeThatGoesBackForgetsWhatIsLaterInAllStreams) {
  StreamStore store({});
  for (int i = 0; i <= 10; ++i) {
    store.add(plotted("a", i, i));
    store.add(plotted("b", i, i));
  }
  store.add(plotted("a", 3.5, 77));
  EXPECT_EQ(store.newest(), timeAt(3.5));
  EXPECT_EQ(valueAt(store, "a", 100), 77);
  EXPECT_EQ(valueAt(store, "b", 100), 3);
  store.add(plotted("b", 4, 78));
  EXPECT_EQ(valueAt(store, "a", 100), 77) << "the other stream goes on without another reset";
}

TEST(StreamStore, tablesOutliveAReset) {
  StreamStore store({});
  store.add({"red1/tables/keys", timeAt(5), std::make_shared<KeyTable>()});
  store.add(plotted("a", 6));
  store.add(plotted("a", 0.1));
  EXPECT_NE(store.latestAs<KeyTable>("red1/tables/keys", timeAt(0.1)), nullptr);
  EXPECT_EQ(store.find("red1/tables/keys")->messages.size(), 1U);
  store.add({"red1/tables/keys", timeAt(0.2), std::make_shared<KeyTable>()});
  EXPECT_EQ(store.find("red1/tables/keys")->messages.size(), 2U);
  EXPECT_EQ(store.find("red1/tables/keys")->count, 2U);
}

TEST(StreamStore, processesThatPublishInOneStreamDoNotResetEachOther) {
  StreamStore store({});
  auto reported = [](const char* process, double time, double value) {
    StreamMessage message = plotted("red1/log", time, value);
    message.process = process;
    return message;
  };
  for (int i = 0; i < 3; ++i) store.add(reported("cognition", 1 + i, 10 + i));
  for (int i = 0; i < 3; ++i) store.add(reported("motion", 1.5 + i, 20 + i));
  const auto& messages = store.find("red1/log")->messages;
  ASSERT_EQ(messages.size(), 6U);
  for (std::size_t i = 1; i < messages.size(); ++i) EXPECT_LT(messages[i - 1].time, messages[i].time);
  EXPECT_EQ(valueAt(store, "red1/log", 1.7), 20);
  store.add(reported("motion", 0.5, 30));
  EXPECT_EQ(store.find("red1/log")->messages.size(), 1U) << "this one did go back";
}

TEST(StreamStore, theRateIsThatOfTheLastSecondAlsoOfStreamsThatFellSilent) {
  StreamStore store({});
  for (int i = 0; i <= 12; ++i) store.add(plotted("camera", i * 0.04));
  EXPECT_NEAR(store.find("camera")->rate, 25, 3) << "right from the start";
  for (int i = 13; i <= 100; ++i) store.add(plotted("camera", i * 0.04));
  EXPECT_NEAR(store.find("camera")->rate, 25, 1);
  for (int i = 1; i <= 20; ++i) store.add(plotted("other", 4 + i * 0.1));
  EXPECT_EQ(store.find("camera")->rate, 0);
  EXPECT_NEAR(store.find("other")->rate, 10, 1);
}

TEST(StreamStore, theListsVersionGrowsWithNewStreamsOnly) {
  StreamStore store({});
  store.add(plotted("red1/a", 0));
  const auto version = store.listVersion();
  store.add(plotted("red1/a", 1));
  EXPECT_EQ(store.listVersion(), version);
  store.add(plotted("red1/b", 1));
  store.add(plotted("red10/c", 1));
  EXPECT_GT(store.listVersion(), version);
  ASSERT_EQ(store.streams("red1/").size(), 2U);
  EXPECT_EQ(store.streams("red1/")[1]->path, "red1/b");
  EXPECT_EQ(store.streams().size(), 3U);
  EXPECT_EQ(store.streams()[0]->type, "robotcontrol.PlotValue");
}

TEST(StreamStore, tooManyStreamsAreRefusedAndCounted) {
  StreamStore store({.streams = 10});
  for (int i = 0; i < 15; ++i) store.add(plotted("stream" + std::to_string(i), 1));
  EXPECT_EQ(store.streams().size(), 10U);
  EXPECT_EQ(store.refused(), 5U);
}

TEST(StreamStore, clearForgetsAll) {
  StreamStore store({});
  store.add(plotted("a", 9));
  store.clear();
  EXPECT_EQ(store.bytes(), 0U);
  EXPECT_EQ(store.newest(), Instant{});
  EXPECT_EQ(store.find("a"), nullptr);
  store.add(plotted("a", 1));
  EXPECT_EQ(store.newest(), timeAt(1));
}
