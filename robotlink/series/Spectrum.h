// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "robotlink/base/Error.h"
#include "robotlink/series/Series.h"

namespace robotlink {

/// The window that values are multiplied by before their spectrum is computed. Each is a sum of cosines (F.
/// J. Harris, On the Use of Windows for Harmonic Analysis with the Discrete Fourier Transform, 1978; the flat
/// top of MATLAB).
enum class SpectrumWindow : std::uint8_t { kRectangle, kHann, kHamming, kBlackman, kFlatTop };

/// The amplitudes of the oscillations in a part of a series.
struct Spectrum {
  /// Distance of the amplitudes in Hz; the first one is at 0 Hz, the last one at half the rate of the
  /// samples.
  double step = 0;
  /// The amplitudes of the oscillations, in the unit of the values: a sine of amplitude 1 has a peak of 1.
  /// The first one is the amount of the mean, which is subtracted before.
  std::vector<double> amplitudes = {};
  /// The rate in Hz at which the series was sampled.
  double rate = 0;
  /// Whether points lie closer together than the samples, since there would be too many.
  bool isThinned = false;
  /// The largest distance of two points, compared with that of samples; far above 1, gaps were bridged.
  double largestGap = 1;
};

/// More samples are not taken.
inline constexpr std::size_t kMaxSpectrumSamples = std::size_t{1} << 18U;

/// Computes the spectrum of the points in [from, to]. They are sampled evenly at their mean distance, between
/// points by straight lines; what is no number is left out. Fails if there are less than 16 points.
Result<Spectrum> spectrumOf(const Series& series, double from, double to, SpectrumWindow window);

}  // namespace robotlink
