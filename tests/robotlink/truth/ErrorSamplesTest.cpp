// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/truth/ErrorSamples.h"

#include <gtest/gtest.h>

#include <limits>

namespace robotlink {
namespace {

TEST(ErrorSamples, withoutSamplesAllIsZero) {
  const ErrorSamples none;
  EXPECT_EQ(none.count(), 0U);
  EXPECT_EQ(none.mean(), 0);
  EXPECT_EQ(none.maximum(), 0);
  EXPECT_EQ(none.quantile(0.5), 0);
}

TEST(ErrorSamples, theLargestMayBeNegative) {
  ErrorSamples samples;
  samples.add(-3);
  samples.add(-2);
  EXPECT_EQ(samples.maximum(), -2);
  EXPECT_EQ(samples.mean(), -2.5);
}

TEST(ErrorSamples, quantilesAreSamples) {
  ErrorSamples samples;
  for (const int amount : {4, 1, 3, 2}) samples.add(amount);
  struct Case {
    double share, amount;
  };
  for (const Case& one :
       {Case{0, 1}, Case{0.25, 1}, Case{0.26, 2}, Case{0.5, 2}, Case{0.75, 3}, Case{0.95, 4}, Case{1, 4}})
    EXPECT_EQ(samples.quantile(one.share), one.amount) << one.share;
}

TEST(ErrorSamples, whatIsNoNumberDoesNotCount) {
  ErrorSamples samples;
  samples.add(1);
  samples.add(std::numeric_limits<double>::quiet_NaN());
  samples.add(std::numeric_limits<double>::infinity());
  EXPECT_EQ(samples.count(), 1U);
  EXPECT_EQ(samples.mean(), 1);
  EXPECT_EQ(samples.maximum(), 1);
}

TEST(ErrorSamples, ofVeryManyTheStatisticsStayRight) {
  ErrorSamples samples;
  const auto count = 10 * ErrorSamples::kMaxKept + 123;
  for (std::size_t i = 0; i < count; ++i) samples.add(static_cast<double>(i) / static_cast<double>(count));
  EXPECT_EQ(samples.count(), count);
  EXPECT_NEAR(samples.mean(), 0.5, 1e-5);
  EXPECT_NEAR(samples.maximum(), 1, 1e-5);
  for (const double share : {0.05, 0.5, 0.95}) EXPECT_NEAR(samples.quantile(share), share, 1e-3) << share;
}

}  // namespace
}  // namespace robotlink
