// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace app {

/// A mean and the bounds of its 95 % confidence interval.
struct MeanInterval {
  double mean = 0, low = 0, high = 0;
};

/// The percentile bootstrap (Efron, B.: Bootstrap methods: another look at the jackknife, 1979), with 2,000
/// resamples of fixed seeds, so that the same values give the same bounds. With fewer than two values the
/// bounds are infinite. A pure function.
MeanInterval bootstrapMean(const std::vector<double>& values);

/// The chance that a mean is as far from 0 as that of these values although they are as often below as above
/// 0: the permutation test of paired differences (Fisher, R. A.: The Design of Experiments, 1935). Exact for
/// up to 12 values, else by 4,000 permutations of fixed seeds. Of n values it is at least 2 / 2^n, whatever
/// they are: five or fewer never tell at the level of 5 %, which bootstrapped bounds hide. 1 without values.
double chanceOf(const std::vector<double>& values);
/// The fewest values with which chanceOf() can tell a difference at the level of 5 %.
inline constexpr std::size_t kFewestForChance = 6;

/// Corrects such chances for their number: of those up to a level, at most that share is due to chance
/// (Benjamini, Y., Hochberg, Y.: Controlling the false discovery rate, 1995).
std::vector<double> corrected(const std::vector<double>& chances);

}  // namespace app
