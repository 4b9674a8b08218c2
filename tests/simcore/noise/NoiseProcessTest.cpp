// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/noise/NoiseProcess.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "simcore/noise/SampleClock.h"

namespace simcore {
namespace {

constexpr double kStep = 0.004;

NoiseProcess processOf(NoiseModel noise, std::uint64_t index = 0, std::size_t channels = 1) {
  return {{7, index}, channels, kStep, {noise}};
}

SensorErrors timing(double delay, double rate, double dropout) {
  return {{}, delay, rate, dropout};
}

/// The errors of one channel in steps 1 to `count`.
std::vector<double> errorsOf(NoiseProcess& process, int count, std::uint64_t seed = 1) {
  std::vector<double> errors;
  for (int step = 1; step <= count; ++step) {
    std::vector<double> value{0};
    process.apply(seed, static_cast<std::uint64_t>(step), value);
    errors.push_back(value[0]);
  }
  return errors;
}

/// Chi-square of numbers against a normal distribution, in 20 classes of equal probability.
double chiSquare(const std::vector<double>& numbers, double mean, double stddev) {
  std::array<int, 20> counts{};
  for (const double number : numbers) {
    const double share = 0.5 * std::erfc(-(number - mean) / stddev / std::sqrt(2.0));
    ++counts[static_cast<std::size_t>(std::min(19.0, std::floor(20 * share)))];
  }
  const double expected = static_cast<double>(numbers.size()) / 20;
  double sum = 0;
  for (const int count : counts) sum += (count - expected) * (count - expected) / expected;
  return sum;
}

// With 19 degrees of freedom, one of a million sequences is beyond this.
constexpr double kMaxChiSquare = 60;

double deviation(const std::vector<double>& numbers) {
  double sum = 0, squares = 0;
  for (const double number : numbers) {
    sum += number;
    squares += number * number;
  }
  const auto count = static_cast<double>(numbers.size());
  return std::sqrt(squares / count - sum / count * (sum / count));
}

TEST(NoiseProcessTest, whiteNoiseHasTheStatedDistribution) {
  NoiseProcess process = processOf({.mean = 0.3, .stddev = 2});
  const auto errors = errorsOf(process, 20'000);
  EXPECT_LT(chiSquare(errors, 0.3, 2), kMaxChiSquare);
  // The test notices what is slightly different.
  EXPECT_GT(chiSquare(errors, 0.5, 2), kMaxChiSquare);
  EXPECT_GT(chiSquare(errors, 0.3, 2.15), kMaxChiSquare);
}

TEST(NoiseProcessTest, neighborsAndChannelsAreIndependent) {
  NoiseProcess process({7, 0}, 2, kStep, {{.stddev = 1}});
  std::vector<double> sums, differences;
  std::vector<double> before{0, 0};
  for (std::uint64_t step = 1; step <= 10'000; ++step) {
    std::vector<double> values{0, 0};
    process.apply(1, step, values);
    sums.push_back(values[0] + values[1]);
    differences.push_back(values[0] - before[0]);
    before = values;
  }
  EXPECT_LT(chiSquare(sums, 0, std::sqrt(2.0)), kMaxChiSquare);
  EXPECT_NEAR(deviation(differences), std::sqrt(2.0), 0.04);
}

TEST(NoiseProcessTest, biasesOfManySensorsHaveTheStatedDistribution) {
  std::vector<double> biases;
  for (std::uint64_t index = 0; index < 5000; ++index) {
    NoiseProcess process = processOf({.biasMean = 5, .biasStddev = 0.5}, index);
    const auto errors = errorsOf(process, 2);
    EXPECT_EQ(errors[0], errors[1]) << "a bias stays";
    biases.push_back(std::abs(errors[0]));
  }
  EXPECT_LT(chiSquare(biases, 5, 0.5), kMaxChiSquare);
}

TEST(NoiseProcessTest, driftBeginsAtZeroAndReachesItsStationaryDeviation) {
  // After many time constants the deviation is driftStddev * sqrt(driftTime / 2).
  const NoiseModel noise{.driftStddev = 3, .driftTime = 0.1};
  std::vector<double> late, early;
  for (std::uint64_t index = 0; index < 3000; ++index) {
    NoiseProcess process = processOf(noise, index);
    std::vector<double> value{0};
    process.apply(1, 1, value);
    early.push_back(value[0]);
    value = {0};
    process.apply(1, 250, value);
    late.push_back(value[0]);
  }
  EXPECT_LT(chiSquare(late, 0, 3 * std::sqrt(0.05)), kMaxChiSquare);
  EXPECT_NEAR(deviation(early), 3 * std::sqrt(kStep), 0.01);
}

TEST(NoiseProcessTest, driftDoesNotDependOnHowOftenItIsRead) {
  const NoiseModel noise{.stddev = 1, .driftStddev = 3, .driftTime = 0.1};
  NoiseProcess often = processOf(noise), once = processOf(noise);
  const auto errors = errorsOf(often, 500);
  std::vector<double> value{0};
  once.apply(1, 500, value);
  EXPECT_EQ(value[0], errors.back());
  // Going back, as after a reset, gives the former numbers again.
  value = {0};
  once.apply(1, 20, value);
  EXPECT_EQ(value[0], errors[19]);
}

TEST(NoiseProcessTest, readingsAreMultiplesOfThePrecision) {
  NoiseProcess process = processOf({.stddev = 1, .precision = 0.25});
  for (const double error : errorsOf(process, 200)) EXPECT_EQ(error * 4, std::round(error * 4));
  NoiseProcess rounding = processOf({.precision = 0.5});
  std::vector<double> value{1.3};
  rounding.apply(1, 1, value);
  EXPECT_EQ(value[0], 1.5);
}

TEST(NoiseProcessTest, seedsAndStreamsGiveOtherNumbers) {
  NoiseProcess a = processOf({.stddev = 1}), b = processOf({.stddev = 1}, 1);
  EXPECT_NE(errorsOf(a, 1), errorsOf(b, 1));
  EXPECT_NE(errorsOf(a, 1, 1), errorsOf(a, 1, 2));
  EXPECT_EQ(errorsOf(a, 1, 1), errorsOf(a, 1, 1));
}

TEST(NoiseProcessTest, aChangeKeepsWhatHasDrifted) {
  NoiseProcess process = processOf({.driftStddev = 3, .driftTime = 100});
  const double drifted = errorsOf(process, 100).back();
  process.change({{.mean = 1}}, 1, 100);
  std::vector<double> value{0};
  process.apply(1, 100, value);
  EXPECT_NEAR(value[0], drifted + 1, 1e-12);
}

TEST(NoiseProcessTest, withoutAnyNoiseItIsTrueWhateverHasDrifted) {
  NoiseProcess process = processOf({.driftStddev = 1, .driftTime = 10});
  ASSERT_NE(errorsOf(process, 100).back(), 0);
  process.change({}, 1, 100);
  std::vector<double> value{5};
  process.apply(1, 101, value);
  EXPECT_EQ(value[0], 5);
}

TEST(NoiseProcessTest, whatForgetsNothingIsARandomWalk) {
  double squares = 0;
  constexpr int kRuns = 300;
  for (std::uint64_t seed = 1; seed <= kRuns; ++seed) {
    NoiseProcess process = processOf({.driftStddev = 2, .driftTime = NoiseModel::kForever});
    std::vector<double> value{0};
    process.apply(seed, 250, value);
    squares += value[0] * value[0];
  }
  EXPECT_NEAR(std::sqrt(squares / kRuns), 2, 0.25) << "after 1 s; after more it is larger by the root";
}

TEST(SampleClockTest, samplesComeAtTheRateWhateverTheStep) {
  const SampleClock clock(timing(0, 60, 0), 0, kStep);
  int samples = 0;
  for (std::uint64_t step = 0; step < 2500; ++step) samples += clock.sampleAt(1, step) ? 1 : 0;
  EXPECT_EQ(samples, 600);
  const SampleClock everyStep(timing(0, 250, 0), 0, kStep);
  for (std::uint64_t step = 0; step < 100; ++step) EXPECT_EQ(everyStep.sampleAt(1, step), step);
}

TEST(SampleClockTest, aDelayedSampleIsReadLater) {
  const SampleClock clock(timing(0.02, 25, 0), 0, kStep);
  EXPECT_EQ(clock.readable(1, 14, 0), 0U);
  EXPECT_EQ(clock.readable(1, 15, 0), 10U);
  EXPECT_EQ(clock.readable(1, 24, 0), 10U);
  EXPECT_EQ(clock.readable(1, 25, 0), 20U);
}

TEST(SampleClockTest, theStatedShareOfSamplesIsLost) {
  const SampleClock clock(timing(0, 0, 0.3), 5, kStep);
  int lost = 0;
  for (std::uint64_t step = 0; step < 10'000; ++step) lost += clock.sampleAt(1, step) ? 0 : 1;
  EXPECT_NEAR(lost, 3000, 200);
  for (std::uint64_t step = 100; step < 200; ++step) {
    const std::uint64_t shown = clock.readable(1, step, 0);
    EXPECT_TRUE(clock.sampleAt(1, shown));
    for (std::uint64_t after = shown + 1; after <= step; ++after) EXPECT_FALSE(clock.sampleAt(1, after));
  }
}

TEST(SensorErrorsTest, whatIsOutOfRangeIsSaid) {
  const auto wrong = [](const SensorErrors& errors) { return std::string(wrongErrors(errors)); };
  EXPECT_EQ(wrong({}), "");
  EXPECT_NE(wrong({.noise = {{.stddev = -1}}}), "");
  EXPECT_NE(wrong({.noise = {{.mean = std::numeric_limits<double>::quiet_NaN()}}}), "");
  EXPECT_NE(wrong(timing(2, 0, 0)), "");
  EXPECT_NE(wrong(timing(0, -1, 0)), "");
  EXPECT_NE(wrong(timing(0, 0, 1.1)), "");
}

}  // namespace
}  // namespace simcore
