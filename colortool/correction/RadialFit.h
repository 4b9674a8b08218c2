// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace colortool {

/// A channel of a patch of uniform color somewhere in an image.
struct RadialSample {
  /// Samples of equal group have the same color in the same light.
  std::size_t group = 0;
  /// See squaredImageRadius().
  double squaredRadius = 0;
  /// The value of the channel; for RadialModel::kShade the logarithm of Y.
  double value = 0;
  /// The weight of the sample in the fit; positive.
  double weight = 1;
};

/// How a value that is `mean` at the image center depends on the distance r from there.
enum class RadialModel : std::uint8_t {
  kShade,  ///< log(value) = mean + log(1 + c0 r^2 + c1 r^4)
  kTint,   ///< value = mean + c0 r^2 + c1 r^4
};

/// The result of fitRadial().
struct RadialFit {
  /// Whether the fit yielded coefficients, or why not.
  enum class Outcome : std::uint8_t {
    /// The effect is significant.
    kFound,
    /// All samples of each group are about equally far from the center.
    kTooNarrow,
    /// The differences may be chance.
    kNothing,
  };
  Outcome outcome = Outcome::kTooNarrow;
  /// c0 and c1; 0 unless the outcome is kFound.
  std::array<double, 2> coefficients{};
};

/// Fits c0 and c1 together with a separate mean for each group, by robust least squares (Huber 1964). A prior
/// pulls the coefficients to 0 where the samples say little.
RadialFit fitRadial(std::span<const RadialSample> samples, RadialModel model);

}  // namespace colortool
