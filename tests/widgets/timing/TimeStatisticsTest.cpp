// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timing/TimeStatistics.h"

#include <gtest/gtest.h>

#include <limits>

#include "widgets/timing/PeriodStatistics.h"

namespace widgets {
namespace {

TEST(TimeStatisticsTest, percentilesAreThoseOfAllTimes) {
  TimeStatistics times;
  for (int i = 1; i <= 1000; ++i) times.add(i * 1e-5);
  EXPECT_EQ(times.count(), 1000U);
  EXPECT_DOUBLE_EQ(times.minimum(), 1e-5);
  EXPECT_DOUBLE_EQ(times.maximum(), 1e-2);
  EXPECT_NEAR(times.mean(), 5.005e-3, 1e-9);
  EXPECT_NEAR(times.percentile(0.5), 5e-3, 5e-5);
  EXPECT_NEAR(times.percentile(0.95), 9.5e-3, 1e-4);
  EXPECT_NEAR(times.percentile(0.99), 9.9e-3, 1e-4);
  EXPECT_DOUBLE_EQ(times.percentile(1), 1e-2) << "no percentile is above the maximum";
}

TEST(PeriodStatisticsTest, theDeviationOfLongRunsKeepsItsDigits) {
  PeriodStatistics periods;
  for (int i = 0; i < 100000; ++i) periods.add(1000 + (i % 2 == 0 ? 1e-5 : -1e-5));
  EXPECT_NEAR(periods.deviation(), 1e-5, 1e-8);
  EXPECT_NEAR(periods.mean(), 1000, 1e-9);
}

TEST(PeriodStatisticsTest, withoutPeriodsAllIsZeroAndImpossibleOnesDoNoHarm) {
  PeriodStatistics periods;
  periods.add(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(periods.count(), 0U);
  EXPECT_EQ(periods.deviation(), 0);
  periods.add(0.04);
  EXPECT_EQ(periods.deviation(), 0);
  EXPECT_EQ(periods.minimum(), 0.04);
}

TEST(TimeStatisticsTest, withoutTimesAllIsZero) {
  const TimeStatistics times;
  EXPECT_EQ(times.mean(), 0);
  EXPECT_EQ(times.percentile(0.5), 0);
}

TEST(TimeStatisticsTest, impossibleTimesDoNoHarm) {
  TimeStatistics times;
  times.add(0);
  times.add(-1);
  times.add(1e9);
  times.add(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(times.count(), 3U) << "what is no number does not count";
  EXPECT_LE(times.percentile(0.99), 1e9);
}

}  // namespace
}  // namespace widgets
