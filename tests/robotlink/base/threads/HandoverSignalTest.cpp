// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/threads/HandoverSignal.h"

#include <gtest/gtest.h>

#include <thread>

namespace robotlink {
namespace {

using namespace std::chrono_literals;

TEST(HandoverSignal, aSignalBeforeTheWaitIsNotLost) {
  HandoverSignal signal;
  signal.signal();
  EXPECT_TRUE(signal.wait(30s));
  EXPECT_FALSE(signal.wait(0ms));
}

TEST(HandoverSignal, manySignalsCountAsOneAndNeverBlock) {
  HandoverSignal signal;
  for (int i = 0; i < 200'000; ++i) signal.signal();
  EXPECT_TRUE(signal.wait(30s));
  EXPECT_FALSE(signal.wait(0ms));
}

TEST(HandoverSignal, twoThreadsWorkInTurn) {
  HandoverSignal there, back;
  int sum = 0;  // belongs to whoever has been signaled
  std::thread other([&] {
    for (int i = 0; i < 1000; ++i) {
      there.wait();
      ++sum;
      back.signal();
    }
  });
  for (int i = 0; i < 1000; ++i) {
    EXPECT_EQ(sum, i);
    there.signal();
    back.wait();
  }
  other.join();
  EXPECT_EQ(sum, 1000);
}

}  // namespace
}  // namespace robotlink
