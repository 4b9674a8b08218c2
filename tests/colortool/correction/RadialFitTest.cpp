// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/correction/RadialFit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace colortool {
namespace {

using Outcome = RadialFit::Outcome;

/// Groups of samples at random distances up to the corner (1), as a lens with these coefficients shows them.
std::vector<RadialSample> samplesOf(RadialModel model, double c0, double c1, double noise, int groups = 6,
                                    int each = 40, double reach = 1) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(0, reach);
  std::normal_distribution<double> error(0, noise);
  std::vector<RadialSample> samples;
  for (int group = 0; group < groups; ++group)
    for (int i = 0; i < each; ++i) {
      const double r2 = place(random), effect = c0 * r2 + c1 * r2 * r2;
      const double mean = model == RadialModel::kShade ? 4 + 0.2 * group : 100 + 10 * group;
      const double value = model == RadialModel::kShade ? mean + std::log(1 + effect) : mean + effect;
      samples.push_back({static_cast<std::size_t>(group), r2, value + error(random), 1});
    }
  return samples;
}

TEST(RadialFit, theShadeOfALensIsFound) {
  const RadialFit fit = fitRadial(samplesOf(RadialModel::kShade, -0.3, -0.1, 0.01), RadialModel::kShade);
  ASSERT_EQ(fit.outcome, Outcome::kFound);
  for (const double r2 : {0.25, 0.5, 1.0})
    EXPECT_NEAR(fit.coefficients[0] * r2 + fit.coefficients[1] * r2 * r2, -0.3 * r2 - 0.1 * r2 * r2, 0.02)
        << r2;
}

TEST(RadialFit, theTintOfALensIsFound) {
  const RadialFit fit = fitRadial(samplesOf(RadialModel::kTint, 12, -4, 0.5), RadialModel::kTint);
  ASSERT_EQ(fit.outcome, Outcome::kFound);
  for (const double r2 : {0.25, 0.5, 1.0})
    EXPECT_NEAR(fit.coefficients[0] * r2 + fit.coefficients[1] * r2 * r2, 12 * r2 - 4 * r2 * r2, 1) << r2;
}

TEST(RadialFit, aFewWildSamplesDoNotMatter) {
  std::vector<RadialSample> samples = samplesOf(RadialModel::kTint, 10, 0, 0.5);
  for (std::size_t i = 0; i < samples.size(); i += 25) samples[i].value += 100;
  const RadialFit fit = fitRadial(samples, RadialModel::kTint);
  ASSERT_EQ(fit.outcome, Outcome::kFound);
  EXPECT_NEAR(fit.coefficients[0] + fit.coefficients[1], 10, 2);
}

TEST(RadialFit, whatMayBeChanceIsNothing) {
  const RadialFit fit = fitRadial(samplesOf(RadialModel::kTint, 0, 0, 2), RadialModel::kTint);
  EXPECT_EQ(fit.outcome, Outcome::kNothing);
  EXPECT_EQ(fit.coefficients[0], 0);
  EXPECT_EQ(fit.coefficients[1], 0);
}

TEST(RadialFit, groupsThatAreAllAtOneDistanceSayNothing) {
  EXPECT_EQ(fitRadial({}, RadialModel::kShade).outcome, Outcome::kTooNarrow);
  std::vector<RadialSample> samples;
  // Far ones are darker, but each group is at one distance: it may be its color.
  for (std::size_t group = 0; group < 5; ++group)
    for (int i = 0; i < 20; ++i)
      samples.push_back({group, 0.2 * static_cast<double>(group), 100 - 5 * static_cast<double>(group), 1});
  EXPECT_EQ(fitRadial(samples, RadialModel::kTint).outcome, Outcome::kTooNarrow);
}

}  // namespace
}  // namespace colortool
