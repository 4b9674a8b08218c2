// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/record/FrameQueue.h"

#include <gtest/gtest.h>

#include "logplayer/record/FrameRing.h"
#include "tests/logplayer/RecordedMessages.h"

using namespace logplayer;
using namespace logplayer::tests;

namespace {

/// A frame of one message that counts as so many bytes; its time is its name.
RecordedFramePtr sized(int name, std::size_t bytes, bool holds = false) {
  StreamMessage message = plot("red1/plots/x", name, 0);
  message.bytes = bytes;
  auto frame = std::make_shared<RecordedFrame>(*frameOf({message}));
  frame->holds = holds;
  return frame;
}

std::vector<int> names(FrameQueue& queue) {
  std::vector<int> result;
  while (const auto entry = queue.pop()) {
    if (entry->frame) {
      result.push_back(
          static_cast<int>(entry->frame->messages[0].time.time_since_epoch().count() / 1'000'000));
    } else {
      entry->job();
      result.push_back(-1);
    }
  }
  return result;
}

}  // namespace

TEST(FrameQueue, whatWaitsComesInItsOrder) {
  FrameQueue queue(1000);
  int jobs = 0;
  queue.push(sized(1, 100));
  queue.push([&] { ++jobs; });
  queue.push(sized(2, 100));
  EXPECT_EQ(queue.bytes(), 200U);
  EXPECT_EQ(names(queue), (std::vector<int>{1, -1, 2}));
  EXPECT_EQ(jobs, 1);
  EXPECT_EQ(queue.bytes(), 0U);
  EXPECT_TRUE(queue.empty());
}

TEST(FrameQueue, theLargestGoesFirstAndOfEqualOnesTheNewest) {
  FrameQueue queue(1000);
  queue.push(sized(1, 300));
  queue.push(sized(2, 400));
  queue.push(sized(3, 300));
  queue.push(sized(4, 200));  // 1200: 2 goes
  EXPECT_EQ(queue.dropped().messages, 1U);
  EXPECT_EQ(queue.dropped().bytes, 400U);
  queue.push(sized(5, 250));  // 1050: of 1 and 3 the newer one
  EXPECT_EQ(names(queue), (std::vector<int>{1, 4, 5}));
  EXPECT_EQ(queue.dropped().messages, 2U);
}

TEST(FrameQueue, aFrameGoesAsAWholeForItsLargestMessage) {
  FrameQueue queue(1000);
  std::vector<StreamMessage> messages{plot("a", 1, 0), plot("b", 1, 0), frameInfo(1, 1)};
  messages[0].bytes = 500;
  messages[1].bytes = messages[2].bytes = 10;
  queue.push(frameOf(messages));
  queue.push(sized(2, 400));
  queue.push(sized(3, 200));
  EXPECT_EQ(names(queue), (std::vector<int>{2, 3}));
  EXPECT_EQ(queue.dropped().messages, 3U);
  EXPECT_EQ(queue.dropped().bytes, 520U);
}

TEST(FrameQueue, whatHoldsGoesOnlyWhenThereIsNothingElse) {
  FrameQueue queue(1000);
  queue.push(sized(1, 800, true));
  queue.push(sized(2, 100));
  queue.push(sized(3, 150));        // 3 is the largest that does not hold
  queue.push(sized(4, 250, true));  // 2, then 1
  EXPECT_EQ(names(queue), (std::vector<int>{4}));
  EXPECT_EQ(queue.dropped().messages, 3U);
}

TEST(FrameQueue, whatIsLargerThanItAllIsLetGoAndJobsAreNot) {
  FrameQueue queue(1000);
  for (int i = 0; i < 100; ++i) queue.push([] {});
  queue.push(sized(1, 1001));
  queue.push(sized(2, 1000));
  EXPECT_EQ(names(queue).size(), 101U);
  EXPECT_EQ(queue.dropped().bytes, 1001U);
}

TEST(FrameRing, keepsTheLastSecondsAndWhatHeldBeforeThem) {
  FrameRing ring(1'000'000);
  ring.add(sized(0, 100));
  EXPECT_TRUE(ring.empty());  // nothing is to be kept
  ring.keep(std::chrono::seconds(1));
  for (int i = 0; i <= 30; ++i) {
    ring.add(frameOf({table("red1/tables/keys", 100 * i, "key" + std::to_string(i)), frameInfo(100 * i, 1)}));
  }
  const FrameRing::Contents contents = ring.contents();
  ASSERT_EQ(contents.frames.size(), 11U);
  EXPECT_EQ(contents.frames.front()->messages[0].time, at(2000));
  EXPECT_EQ(ring.span(), std::chrono::seconds(1));
  ASSERT_EQ(contents.held.size(), 1U);
  EXPECT_EQ(contents.held[0].time, at(1900));
  ring.keep({});
  EXPECT_TRUE(ring.empty());
  EXPECT_EQ(ring.bytes(), 0U);
}

TEST(FrameRing, isBoundedByItsBytesToo) {
  FrameRing ring(1000);
  ring.keep(std::chrono::seconds(100));
  for (int i = 0; i < 20; ++i) ring.add(sized(i, 300));
  EXPECT_EQ(ring.contents().frames.size(), 3U);
  EXPECT_EQ(ring.bytes(), 900U);
}

TEST(FrameRing, aBookmarkInThePastDoesNotMoveItsEnd) {
  FrameRing ring(1'000'000);
  ring.keep(std::chrono::seconds(1));
  for (int i = 0; i <= 20; ++i) ring.add(sized(100 * i, 100));
  ring.add(sized(500, 100));
  EXPECT_EQ(ring.span(), std::chrono::seconds(1));
  EXPECT_EQ(ring.contents().frames.size(), 12U);
}
