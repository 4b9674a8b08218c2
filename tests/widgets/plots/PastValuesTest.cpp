// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/PastValues.h"

#include <gtest/gtest.h>

namespace widgets::test {
namespace {

using robotlink::PointFilter;
using robotlink::Series;

/// A value each second, of which those from kBegin on are published and the others are on disk.
class PastValuesTest : public testing::Test {
 protected:
  static constexpr int kBegin = 4000, kEnd = 5000;

  void publish(int from, int to) {
    for (int i = from; i < to; ++i) {
      past_.note({1.0 * i, 1.0 * i}, !filter_.isEmpty());
      if (const auto result = filter_.next({1.0 * i, 1.0 * i})) live_.append(*result);
    }
  }
  void readUntil(int end) {
    // A part of what was published is on disk, too, since it went there later.
    for (; next_ < end; ++next_) read_->series.append({1.0 * next_, 1.0 * next_});
  }

  PointFilter filter_;
  PastValues past_;
  Series live_;
  std::shared_ptr<LoggedCurve> read_ = std::make_shared<LoggedCurve>();
  int next_ = 0;
};

TEST_F(PastValuesTest, whatIsReadComesBeforeWhatIsPublishedWithoutBeingTwice) {
  EXPECT_FALSE(past_.isWanted());
  publish(kBegin, kEnd - 10);
  EXPECT_TRUE(past_.isWanted());
  EXPECT_TRUE(past_.unread());
  past_.read(read_);
  EXPECT_FALSE(past_.isWanted());
  readUntil(500);
  EXPECT_FALSE(past_.mergeInto(live_, filter_)) << "it costs too much for so few";
  readUntil(2000);
  EXPECT_TRUE(past_.mergeInto(live_, filter_));
  EXPECT_EQ(past_.unread(), std::pair(1999.0, 1.0 * kBegin));
  publish(kEnd - 10, kEnd);
  readUntil(kBegin + 100);
  read_->isComplete = true;
  EXPECT_TRUE(past_.mergeInto(live_, filter_));
  EXPECT_FALSE(past_.unread());
  EXPECT_FALSE(past_.mergeInto(live_, filter_));
  ASSERT_EQ(live_.size(), std::size_t{kEnd});
  for (std::size_t i = 0; i < live_.size(); ++i) ASSERT_EQ(live_[i].time, static_cast<double>(i));
}

TEST_F(PastValuesTest, filtersComputeOverBoth) {
  filter_ = *PointFilter::parse("integral");
  PointFilter whole = filter_;
  publish(kBegin, kEnd);
  past_.read(read_);
  readUntil(kBegin);
  read_->isComplete = true;
  EXPECT_TRUE(past_.mergeInto(live_, filter_));
  double last = 0;
  for (int i = 0; i <= kEnd; ++i) last = whole.next({1.0 * i, 1.0 * i})->value;
  ASSERT_EQ(live_.size(), std::size_t{kEnd});
  EXPECT_EQ(filter_.next({kEnd, kEnd})->value, last) << "it goes on with the sum of all";
}

TEST_F(PastValuesTest, whatIsNotReadIsNotMissing) {
  publish(kBegin, kEnd);
  past_.skip();
  EXPECT_FALSE(past_.isWanted() || past_.unread() || past_.mergeInto(live_, filter_));
  past_.restart();
  EXPECT_FALSE(past_.begin());
}

}  // namespace
}  // namespace widgets::test
