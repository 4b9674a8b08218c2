// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/series/Statistics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace robotlink {

TEST(StatisticsTest, areThoseOfTheValuesThatAreNumbers) {
  Series series;
  for (const double value : {100.0, 2.0, 4.0, std::nan(""), 4.0, 4.0, 5.0, 5.0, 7.0, 9.0, -100.0})
    series.append({static_cast<double>(series.size()), value});
  const Statistics some = statistics(series, 1, series.size() - 1);
  EXPECT_EQ(some.count, 8U);
  EXPECT_EQ(some.min, 2);
  EXPECT_EQ(some.max, 9);
  EXPECT_DOUBLE_EQ(some.mean, 5);
  EXPECT_DOUBLE_EQ(some.deviation, 2);
  const Statistics none = statistics(series, 3, 4);
  EXPECT_EQ(none.count, 0U);
  EXPECT_TRUE(std::isnan(none.min) && std::isnan(none.mean) && std::isnan(none.deviation));
}

TEST(StatisticsTest, smallDeviationsOfLargeValuesAreExact) {
  Series series;
  for (int i = 0; i < 1000; ++i) series.append({static_cast<double>(i), 1e9 + (i % 2)});
  EXPECT_NEAR(statistics(series, 0, series.size()).deviation, 0.5, 1e-6);
}

}  // namespace robotlink
