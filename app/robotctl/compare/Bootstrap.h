// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace app {

/// A mean with the bounds between which it lies with 95 % confidence.
struct MeanInterval {
  double mean = 0, low = 0, high = 0;
};

/// The percentile bootstrap (Efron, B.: Bootstrap methods: another look at the jackknife, 1979), with 2,000
/// resamples of fixed seeds, so that the same values give the same bounds. With fewer than two values the
/// bounds are infinite. A pure function.
MeanInterval bootstrapMean(const std::vector<double>& values);

}  // namespace app
