// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/server/Outbox.h"

#include <gmock/gmock.h>

#include <array>

namespace robotlink::websocket::test {
namespace {

using std::chrono::milliseconds;
using testing::ElementsAre;

constexpr std::size_t kMany = 1000;

class OutboxTest : public testing::Test {
 protected:
  static Outgoing message(const std::string& text) {
    return {FrameKind::kBinary, {}, 0, std::make_shared<const std::string>(text)};
  }
  void push(Outbox::StreamId stream, const std::string& text, Delivery delivery,
            std::size_t maxWaiting = kMany) {
    outbox_.push(stream, message(text), delivery, maxWaiting);
  }
  bool pushControl(const std::string& text) {
    return outbox_.pushControl(FrameKind::kText, std::make_shared<const std::string>(text));
  }
  std::vector<std::string> sent(Instant now = {}) {
    std::vector<std::string> texts;
    while (const auto next = outbox_.next(now)) texts.push_back(*next->payload);
    return texts;
  }

  Outbox outbox_{{4, 100, 50}};
};

TEST_F(OutboxTest, aNewerMessageOfALatestStreamReplacesTheUnsentOneInItsTurn) {
  push(1, "image 1", Delivery::kLatest);
  push(2, "text", Delivery::kComplete);
  push(1, "image 2", Delivery::kLatest);
  push(1, "image 3", Delivery::kLatest);
  EXPECT_THAT(sent(), ElementsAre("image 3", "text"));
  EXPECT_EQ(outbox_.counters(1), (StreamCounters{1, 7, 2, 0}));
  EXPECT_EQ(outbox_.counters(2), (StreamCounters{1, 4, 0, 0}));
  EXPECT_TRUE(outbox_.isEmpty());
  EXPECT_EQ(outbox_.waitingBytes(), 0U);
}

TEST_F(OutboxTest, whileLittleWaitsNothingIsThinned) {
  Outbox calm({4, 100, 50, 10});
  for (const char* text : {"one", "two", "six"}) calm.push(1, message(text), Delivery::kLatest, kMany);
  EXPECT_EQ(calm.counters(1).thinned, 0U);
  calm.push(1, message("seven"), Delivery::kLatest, kMany);
  std::vector<std::string> texts;
  while (const auto next = calm.next({})) texts.push_back(*next->payload);
  EXPECT_THAT(texts, ElementsAre("seven"));
  EXPECT_EQ(calm.counters(1).thinned, 3U);
}

TEST_F(OutboxTest, ofAStreamWithARateTheNewestMessageWaitsUntilItIsDue) {
  using std::chrono::seconds;
  Outbox outbox({4, 100, 50, 10});
  const auto takenAt = [&](Instant now) {
    std::vector<std::string> texts;
    while (const auto next = outbox.next(now)) {
      texts.push_back(*next->payload);
      EXPECT_EQ(next->hasMore, false) << "what is not due keeps nothing back";
    }
    return texts;
  };
  outbox.setRate(1, 0.5);
  outbox.push(1, message("a"), Delivery::kLatest, kMany);
  EXPECT_THAT(takenAt(Instant(seconds(10))), ElementsAre("a"));
  outbox.push(1, message("b"), Delivery::kLatest, kMany);
  outbox.push(1, message("c"), Delivery::kLatest, kMany);
  EXPECT_THAT(takenAt(Instant(seconds(11))), ElementsAre());
  outbox.push(2, message("text"), Delivery::kComplete, kMany);
  EXPECT_THAT(takenAt(Instant(seconds(11))), ElementsAre("text"));
  EXPECT_THAT(takenAt(Instant(seconds(12))), ElementsAre("c"));
  EXPECT_EQ(outbox.counters(1), (StreamCounters{2, 2, 1, 0}));
  // What was sent a little late does not make the rate lower.
  outbox.push(1, message("d"), Delivery::kLatest, kMany);
  EXPECT_THAT(takenAt(Instant(seconds(15))), ElementsAre("d"));
  outbox.push(1, message("e"), Delivery::kLatest, kMany);
  EXPECT_THAT(takenAt(Instant(seconds(16))), ElementsAre("e"));
  outbox.setRate(1, 0);
  for (const char* text : {"f", "g"}) outbox.push(1, message(text), Delivery::kLatest, kMany);
  EXPECT_EQ(outbox.counters(1).thinned, 1U);
}

TEST_F(OutboxTest, aHeavyMessageThatWaitsThinsNoLightStream) {
  Outbox outbox({4, 1000, 500, 10});
  const std::string image(100, 'i');
  outbox.push(1, message(image), Delivery::kLatest, kMany);
  for (const char* text : {"one", "two", "six"}) outbox.push(2, message(text), Delivery::kLatest, kMany);
  EXPECT_EQ(outbox.counters(2).thinned, 0U);
  outbox.push(1, message(image), Delivery::kLatest, kMany);
  EXPECT_EQ(outbox.counters(1).thinned, 1U) << "images are thinned as before";
  std::vector<std::string> texts;
  while (const auto next = outbox.next({})) texts.push_back(*next->payload);
  EXPECT_THAT(texts, ElementsAre(image, "one", "two", "six"));
  EXPECT_EQ(outbox.waitingBytes(), 0U);
}

/// What a line of so many bytes a second carries of two streams in so many seconds, as messages of each:
/// images of 9 kB 25 times a second, and readings of 400 B 125 times a second.
std::array<int, 2> carried(double bytesPerSecond, int seconds) {
  Outbox outbox({1024, 16U << 20U, 16U << 20U, 8192, 4096});
  const auto image = std::make_shared<const std::string>(9000, 'i');
  const auto reading = std::make_shared<const std::string>(400, 'r');
  std::array<int, 2> count{};
  double sent = 0;
  for (int ms = 0; ms < 1000 * seconds; ms += 4) {
    const auto push = [&](Outbox::StreamId id, const SharedBytes& bytes) {
      outbox.push(id, {FrameKind::kBinary, {}, 0, bytes}, Delivery::kLatest, kMany);
    };
    if (ms % 8 == 0) push(1, reading);
    if (ms % 40 == 0) push(0, image);
    while (sent < bytesPerSecond * ms / 1000) {
      const auto next = outbox.next(Instant(milliseconds(ms)));
      if (!next) {
        sent = bytesPerSecond * ms / 1000;
        break;
      }
      sent += static_cast<double>(next->size());
      ++count[next->size() < 1000 ? 1 : 0];
    }
  }
  return count;
}

TEST_F(OutboxTest, onANarrowLineReadingsDoNotWaitForOneImageEach) {
  const auto [images, readings] = carried(80'000, 10);
  EXPECT_GT(readings, 800) << "35 of 50 kB/s, not one for each image";
  EXPECT_GT(images, 40) << "the other half of the line";
  const auto [allImages, allReadings] = carried(1'000'000, 10);
  EXPECT_GE(allImages, 249);
  EXPECT_GE(allReadings, 1249);
}

TEST_F(OutboxTest, messagesOfAStreamKeepTheirOrderWhateverTheirSize) {
  Outbox outbox({4, 100, 50, 0, 3});
  for (const char* text : {"large 1", "s", "large 2"})
    outbox.push(1, message(text), Delivery::kComplete, kMany);
  outbox.push(2, message("t"), Delivery::kComplete, kMany);
  std::vector<std::string> texts;
  while (const auto next = outbox.next({})) texts.push_back(*next->payload);
  EXPECT_THAT(texts, ElementsAre("large 1", "t", "s", "large 2"));
}

TEST_F(OutboxTest, aCompleteStreamDropsItsOldestOverItsBoundAndCountsIt) {
  for (const char* text : {"a", "b", "c", "d"}) push(1, text, Delivery::kComplete, 2);
  EXPECT_THAT(sent(), ElementsAre("c", "d"));
  EXPECT_EQ(outbox_.counters(1), (StreamCounters{2, 2, 0, 2}));
}

TEST_F(OutboxTest, bytesOfAllStreamsTogetherAreBounded) {
  push(1, std::string(30, 'a'), Delivery::kLatest);
  push(2, std::string(15, 'b'), Delivery::kComplete);
  push(3, std::string(20, 'c'), Delivery::kComplete);
  EXPECT_EQ(outbox_.waitingBytes(), 35U);
  EXPECT_EQ(outbox_.counters(1).thinned, 1U);
  push(4, std::string(500, 'd'), Delivery::kLatest);
  EXPECT_THAT(sent(), ElementsAre(std::string(500, 'd'))) << "what is larger than the bound waits alone";
  EXPECT_EQ(outbox_.counters(2).dropped + outbox_.counters(3).dropped, 2U);
}

TEST_F(OutboxTest, controlMessagesGoFirstAndAreNeverDroppedSilently) {
  push(1, "image", Delivery::kLatest);
  EXPECT_TRUE(pushControl("one") && pushControl("two") && pushControl("three") && pushControl("four"));
  EXPECT_FALSE(pushControl("five")) << "four messages are the bound";
  EXPECT_THAT(sent(), ElementsAre("one", "two", "three", "four", "image"));
  EXPECT_TRUE(pushControl(std::string(500, 'x'))) << "a large one may wait alone";
  EXPECT_FALSE(pushControl("y"));
}

TEST_F(OutboxTest, whatIsNotWantedAnyMoreIsForgotten) {
  push(1, "a", Delivery::kComplete);
  push(2, "b", Delivery::kComplete);
  push(1, "c", Delivery::kComplete);
  outbox_.clear(1);
  push(1, "d", Delivery::kComplete);
  EXPECT_THAT(sent(), ElementsAre("b", "d"));
  push(1, "e", Delivery::kComplete);
  pushControl("f");
  outbox_.clear();
  EXPECT_TRUE(outbox_.isEmpty());
  outbox_.remove(1);
  EXPECT_EQ(outbox_.counters(1), StreamCounters());
}

TEST_F(OutboxTest, aBudgetHoldsBackStreamsButNotControl) {
  outbox_.budget().setRate(1000);
  const auto at = [](int ms) { return Instant(milliseconds(1000 + ms)); };
  std::size_t bytes = 0;
  for (int ms = 0; ms < 5000; ms += 10) {
    push(1, std::string(40, 'a'), Delivery::kLatest);
    for (const std::string& text : sent(at(ms))) bytes += text.size();
  }
  EXPECT_NEAR(static_cast<double>(bytes), 5000 + 100, 60) << "a tenth of a second may be saved up";
  push(1, "image", Delivery::kLatest);
  pushControl(std::string(200, 'c'));
  EXPECT_THAT(sent(at(5000)), ElementsAre(std::string(200, 'c')));
  EXPECT_THAT(sent(at(5100)), ElementsAre()) << "control messages are paid for, too";
  EXPECT_THAT(sent(at(5400)), ElementsAre("image"));
}

TEST_F(OutboxTest, aSlowLineGetsTheNewestFrameWholeHoweverLargeItIs) {
  Outbox line({10, 1000, 1U << 20U});
  line.budget().setRate(10'000);
  std::vector<int> ages;
  for (int ms = 0; ms < 10'000; ms += 40) {  // 25 frames of 4 kB a second: ten times the budget
    line.push(1, message(std::to_string(ms) + std::string(4000, ' ')), Delivery::kLatest, 1);
    if (const auto next = line.next(Instant(milliseconds(ms))))
      ages.push_back(ms - std::stoi(*next->payload));
  }
  EXPECT_NEAR(static_cast<double>(ages.size()), 25, 2);
  EXPECT_THAT(ages, testing::Each(0)) << "no frame grows old";
  EXPECT_GT(line.counters(1).thinned, 200U);
}

}  // namespace
}  // namespace robotlink::websocket::test
