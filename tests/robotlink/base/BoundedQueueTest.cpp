// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/BoundedQueue.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <thread>

namespace robotlink {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(BoundedQueue, drainsInOrderAndIsEmptyAfterwards) {
  BoundedQueue<int> queue(3);
  for (const int value : {3, 1, 2}) EXPECT_TRUE(queue.push(value));
  EXPECT_THAT(queue.drain(), ElementsAre(3, 1, 2));
  EXPECT_THAT(queue.drain(), IsEmpty());
}

TEST(BoundedQueue, whatIsPushedIntoAFullQueueIsDroppedAndCounted) {
  BoundedQueue<int> queue(2);
  for (const int value : {1, 2}) EXPECT_TRUE(queue.push(value));
  for (const int value : {3, 4}) EXPECT_FALSE(queue.push(value));
  EXPECT_EQ(queue.dropped(), 2U);
  EXPECT_THAT(queue.drain(), ElementsAre(1, 2)) << "the oldest are kept";
  EXPECT_TRUE(queue.push(5));
  EXPECT_EQ(queue.dropped(), 2U) << "draining does not forget what was lost";
}

TEST(BoundedQueue, whatMustArriveIsQueuedInItsOrderEvenIfItIsFull) {
  BoundedQueue<int> queue(1);
  EXPECT_TRUE(queue.push(1));
  queue.pushAlways(2);
  EXPECT_FALSE(queue.push(3));
  EXPECT_EQ(queue.dropped(), 1U);
  EXPECT_THAT(queue.drain(), ElementsAre(1, 2));
}

TEST(BoundedQueue, aQueueWithoutCapacityDropsEverything) {
  BoundedQueue<int> queue(0);
  EXPECT_FALSE(queue.push(1));
  EXPECT_THAT(queue.drain(), IsEmpty());
  EXPECT_EQ(queue.dropped(), 1U);
}

TEST(BoundedQueue, valuesAreMoved) {
  BoundedQueue<std::unique_ptr<int>> queue(1);
  EXPECT_TRUE(queue.push(std::make_unique<int>(7)));
  EXPECT_EQ(*queue.drain().front(), 7);
}

TEST(BoundedQueue, producersLoseNothingThatIsNotCounted) {
  constexpr int kEach = 20'000;
  BoundedQueue<int> queue(100);
  std::size_t drained = 0;
  {
    std::vector<std::jthread> producers;
    for (int i = 0; i < 3; ++i) {
      producers.emplace_back([&queue] {
        for (int value = 0; value < kEach; ++value) queue.push(value);
      });
    }
    for (int i = 0; i < 100; ++i) drained += queue.drain().size();
  }
  drained += queue.drain().size();
  EXPECT_EQ(drained + queue.dropped(), 3U * kEach);
}

}  // namespace
}  // namespace robotlink
