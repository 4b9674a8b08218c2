// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace simcore::truth {

/// The distance of Kolmogorov and Smirnov between samples and a normal distribution, times the root of their
/// number: the largest difference between both distribution functions. With the right distribution it is
/// above kKolmogorovLimit in one of 10,000 cases.
double kolmogorovOfNormal(std::vector<double> samples, double mean, double deviation);
inline constexpr double kKolmogorovLimit = 2.225;

/// Pearson's chi-square for samples that should be uniform in [low, high), over so many bins, as the number
/// of standard deviations that it is above its mean (Wilson and Hilferty's approximation). Above
/// kChiSquareLimit in one of 10,000 cases.
double chiSquareOfUniform(std::span<const double> samples, double low, double high, int bins);
/// The same for counts with known probabilities.
double chiSquare(std::span<const double> counts, std::span<const double> expected);
inline constexpr double kChiSquareLimit = 3.72;

}  // namespace simcore::truth
