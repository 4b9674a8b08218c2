// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timing/FrameRate.h"

#include <gtest/gtest.h>

namespace widgets {
namespace {

using robotlink::Instant;
using std::chrono::milliseconds;

Instant atMs(int ms) {
  return Instant(milliseconds(ms));
}

TEST(FrameRate, oneFrameIsNoRate) {
  FrameRate rate;
  EXPECT_EQ(rate.hertz(), 0);
  EXPECT_EQ(rate.newest(), 0U);
  EXPECT_FALSE(rate.isNewest({}));
  rate.add(atMs(100), 7);
  EXPECT_EQ(rate.hertz(), 0);
  EXPECT_EQ(rate.period(0), 0);
  EXPECT_EQ(rate.newest(), 7U);
  EXPECT_TRUE(rate.isNewest(atMs(100)));
  EXPECT_FALSE(rate.isNewest(atMs(101)));
}

TEST(FrameRate, framesThatWereNotPublishedCount) {
  FrameRate rate;
  rate.add(atMs(0), 1);
  rate.add(atMs(1000), 51);
  EXPECT_DOUBLE_EQ(rate.hertz(), 50);
  EXPECT_DOUBLE_EQ(rate.period(0), 0.02);
  EXPECT_DOUBLE_EQ(rate.period(0.008), 0.008) << "a process that has a period keeps it";
}

TEST(FrameRate, framesWithoutNumbersAreCounted) {
  FrameRate rate;
  for (int i = 0; i <= 10; ++i) rate.add(atMs(40 * i), 0);
  EXPECT_DOUBLE_EQ(rate.hertz(), 25);
  EXPECT_EQ(rate.newest(), 11U);
}

TEST(FrameRate, onlyTheLastTwoSecondsCount) {
  FrameRate rate;
  std::uint64_t number = 0;
  for (int ms = 0; ms < 5000; ms += 10) rate.add(atMs(ms), ++number);
  for (int ms = 5000; ms <= 8000; ms += 100) rate.add(atMs(ms), ++number);
  EXPECT_NEAR(rate.hertz(), 10, 1e-9);
}

TEST(FrameRate, itStartsOverAfterAReset) {
  FrameRate rate;
  rate.add(atMs(1000), 100);
  rate.add(atMs(1100), 110);
  rate.add(atMs(50), 120);  // the clock went back
  EXPECT_EQ(rate.hertz(), 0);
  rate.add(atMs(150), 130);
  EXPECT_DOUBLE_EQ(rate.hertz(), 100);
  rate.add(atMs(250), 1);  // another program
  EXPECT_EQ(rate.hertz(), 0);
  EXPECT_EQ(rate.newest(), 1U);
}

TEST(FrameRate, framesOfTheSameTimeHaveNoRate) {
  FrameRate rate;
  rate.add(atMs(10), 1);
  rate.add(atMs(10), 2);
  EXPECT_EQ(rate.hertz(), 0);
}

}  // namespace
}  // namespace widgets
