// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/series/Spectrum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace robotlink;

namespace {

/// 2 + 3 sin(2 pi 5 t) + 0.5 sin(2 pi 20 t), 100 times a second.
Series tones(int count, double from = 10) {
  Series series;
  for (int i = 0; i < count; ++i) {
    const double t = 0.01 * i, turn = 2 * std::numbers::pi * t;
    series.append({from + t, 2 + 3 * std::sin(5 * turn) + 0.5 * std::sin(20 * turn)});
  }
  return series;
}

double amplitudeAt(const Spectrum& spectrum, double frequency) {
  const auto near = static_cast<std::ptrdiff_t>(std::lround(frequency / spectrum.step));
  const auto begin = spectrum.amplitudes.begin() + std::max<std::ptrdiff_t>(near - 1, 0);
  return *std::max_element(begin, begin + 3);
}

}  // namespace

TEST(SpectrumTest, amplitudesAreThoseOfTheOscillationsWhateverTheWindow) {
  const Series series = tones(1000);
  for (const auto window : {SpectrumWindow::kRectangle, SpectrumWindow::kHann, SpectrumWindow::kHamming,
                            SpectrumWindow::kBlackman, SpectrumWindow::kFlatTop}) {
    SCOPED_TRACE(static_cast<int>(window));
    const auto spectrum = spectrumOf(series, 10, 30, window);
    ASSERT_TRUE(spectrum);
    EXPECT_NEAR(spectrum->rate, 100, 0.1);
    EXPECT_NEAR(spectrum->step * static_cast<double>(spectrum->amplitudes.size() - 1), 50, 0.1);
    EXPECT_NEAR(amplitudeAt(*spectrum, 5), 3, 0.05);
    EXPECT_NEAR(amplitudeAt(*spectrum, 20), 0.5, 0.02);
    EXPECT_LT(amplitudeAt(*spectrum, 35), 0.05);
    EXPECT_NEAR(spectrum->amplitudes.front(), 2, 0.01) << "the mean";
    EXPECT_FALSE(spectrum->isThinned);
    EXPECT_LT(spectrum->largestGap, 1.2);
  }
}

TEST(SpectrumTest, onlyThePointsOfTheSpanCount) {
  Series series = tones(1000);
  for (int i = 0; i < 1000; ++i) series.append({20 + 0.01 * i, 100});
  const auto spectrum = spectrumOf(series, 10, 19.99, SpectrumWindow::kHann);
  ASSERT_TRUE(spectrum);
  EXPECT_NEAR(spectrum->amplitudes.front(), 2, 0.01);
}

TEST(SpectrumTest, aPrimeNumberOfPointsIsNoProblem) {
  const auto spectrum = spectrumOf(tones(997), 0, 100, SpectrumWindow::kHann);
  ASSERT_TRUE(spectrum);
  EXPECT_NEAR(amplitudeAt(*spectrum, 5), 3, 0.2);
  EXPECT_GT(spectrum->amplitudes.size(), 480U);
}

TEST(SpectrumTest, gapsAndWhatIsNoNumberAreBridged) {
  Series series;
  for (int i = 0; i < 1000; ++i) {
    if (i >= 500 && i < 520) continue;
    const double t = 0.01 * i;
    series.append({t, i % 50 == 0 ? std::nan("") : std::sin(2 * std::numbers::pi * 5 * t)});
  }
  const auto spectrum = spectrumOf(series, 0, 10, SpectrumWindow::kHann);
  ASSERT_TRUE(spectrum);
  EXPECT_NEAR(amplitudeAt(*spectrum, 5), 1, 0.1);
  EXPECT_GT(spectrum->largestGap, 15);
}

TEST(SpectrumTest, tooManyPointsAreThinnedAndTooFewRefused) {
  Series series;
  for (std::size_t i = 0; i < 2 * kMaxSpectrumSamples; ++i) series.append({1e-4 * static_cast<double>(i), 1});
  const auto many = spectrumOf(series, 0, 1e9, SpectrumWindow::kHann);
  ASSERT_TRUE(many);
  EXPECT_TRUE(many->isThinned);
  EXPECT_LE(many->amplitudes.size(), kMaxSpectrumSamples / 2 + 1);
  EXPECT_FALSE(spectrumOf(tones(15), 0, 100, SpectrumWindow::kHann));
  EXPECT_FALSE(spectrumOf(Series(), 0, 100, SpectrumWindow::kHann));
  Series still;
  for (int i = 0; i < 20; ++i) still.append({1, 5});
  EXPECT_FALSE(spectrumOf(still, 0, 100, SpectrumWindow::kHann)) << "all points are of one instant";
}
