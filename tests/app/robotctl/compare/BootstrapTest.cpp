// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/compare/Bootstrap.h"

#include <gtest/gtest.h>

#include <cmath>

namespace app {
namespace {

TEST(Bootstrap, tooFewValuesBoundNothing) {
  EXPECT_EQ(bootstrapMean({}).mean, 0);
  EXPECT_EQ(bootstrapMean({7}).mean, 7);
  for (const auto& values : {std::vector<double>{}, std::vector<double>{7}}) {
    EXPECT_TRUE(std::isinf(bootstrapMean(values).low));
    EXPECT_LT(bootstrapMean(values).low, 0);
    EXPECT_TRUE(std::isinf(bootstrapMean(values).high));
  }
}

TEST(Bootstrap, equalValuesLeaveNoDoubt) {
  const MeanInterval interval = bootstrapMean(std::vector<double>(20, 1.5));
  EXPECT_EQ(interval.mean, 1.5);
  EXPECT_EQ(interval.low, 1.5);
  EXPECT_EQ(interval.high, 1.5);
}

TEST(Bootstrap, theSameValuesGiveTheSameBounds) {
  const std::vector<double> values{1, 5, 2, 8, 3};
  EXPECT_EQ(bootstrapMean(values).low, bootstrapMean(values).low);
  EXPECT_EQ(bootstrapMean(values).high, bootstrapMean(values).high);
}

TEST(Bootstrap, theBoundsAreThoseOfTheNormalDistributionForManyValues) {
  std::vector<double> values;
  for (int i = 0; i < 400; ++i) values.push_back(i % 2);
  const MeanInterval interval = bootstrapMean(values);
  EXPECT_EQ(interval.mean, 0.5);
  // 1.96 standard deviations of the mean, 0.5 / 20.
  EXPECT_NEAR(interval.low, 0.5 - 1.96 * 0.025, 0.005);
  EXPECT_NEAR(interval.high, 0.5 + 1.96 * 0.025, 0.005);
}

TEST(Bootstrap, skewedValuesHaveSkewedBounds) {
  std::vector<double> values(19, 0);
  values.push_back(100);
  const MeanInterval interval = bootstrapMean(values);
  EXPECT_EQ(interval.mean, 5);
  EXPECT_EQ(interval.low, 0);
  EXPECT_GT(interval.high, 10);
}

TEST(Chance, isThatOfTheSigns) {
  EXPECT_EQ(chanceOf({}), 1);
  EXPECT_EQ(chanceOf({3}), 1);
  EXPECT_EQ(chanceOf({1, 2, 3}), 0.25) << "three runs that agree tell nothing";
  EXPECT_EQ(chanceOf(std::vector<double>(kFewestForChance, 1)), 2.0 / 64);
  EXPECT_GT(chanceOf(std::vector<double>(kFewestForChance - 1, 1)), 0.05);
  EXPECT_EQ(chanceOf({1, -1, 1, -1}), 1);
  EXPECT_EQ(chanceOf({1, 1, -1}), 1);
  EXPECT_EQ(chanceOf({0, 0, 0, 0}), 1);
}

TEST(Chance, ofManyValuesIsThatOfTheNormalDistribution) {
  std::vector<double> values;
  for (int i = 0; i < 100; ++i) values.push_back(i < 60 ? 1 : -1);
  // 2 (1 - Phi(19 / 10)), with the correction for continuity.
  EXPECT_NEAR(chanceOf(values), 0.0569, 0.01);
  EXPECT_EQ(chanceOf(values), chanceOf(values));
}

TEST(Chance, isCorrectedForTheNumberOfTests) {
  EXPECT_TRUE(corrected({}).empty());
  EXPECT_EQ(corrected({0.03}), std::vector<double>{0.03});
  const auto four = corrected({0.04, 0.01, 0.5, 0.02});
  EXPECT_NEAR(four[0], 0.04 * 4 / 3, 1e-12);
  EXPECT_NEAR(four[1], 0.04, 1e-12);
  EXPECT_EQ(four[2], 0.5);
  EXPECT_NEAR(four[3], 0.04, 1e-12);
  for (const double one : corrected(std::vector<double>(30, 0.04))) EXPECT_NEAR(one, 0.04, 1e-12);
}

}  // namespace
}  // namespace app
