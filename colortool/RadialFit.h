// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace colortool {

/// A channel of something of one colour, somewhere in an image.
struct RadialSample {
  std::size_t group = 0;  ///< of the same colour, in the same light
  double squaredRadius = 0;
  double value = 0;  ///< for RadialModel::kShade the logarithm of Y
  double weight = 1;
};

/// What the distance r from the image's centre does to a value that is `mean` there.
enum class RadialModel : std::uint8_t {
  kShade,  ///< log(value) = mean + log(1 + c0 r^2 + c1 r^4)
  kTint,   ///< value = mean + c0 r^2 + c1 r^4
};

struct RadialFit {
  enum class Outcome : std::uint8_t {
    kFound,
    kTooNarrow,  ///< the samples of each group are about equally far from the centre
    kNothing,    ///< they differ no more than by chance
  };
  Outcome outcome = Outcome::kTooNarrow;
  std::array<double, 2> coefficients{};  ///< 0 unless found
};

/// Fits c0 and c1, and a mean of its own for each group, by least squares in which outliers count less
/// (Huber 1964), and small coefficients are preferred where samples say little.
RadialFit fitRadial(std::span<const RadialSample> samples, RadialModel model);

}  // namespace colortool
