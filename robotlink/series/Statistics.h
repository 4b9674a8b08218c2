// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/series/Series.h"

namespace robotlink {

/// Descriptive statistics of a set of values. NaN is ignored; without values all but `count` are NaN.
struct Statistics {
  std::size_t count = 0;
  double min = std::numeric_limits<double>::quiet_NaN();
  double max = min, mean = min;
  /// Standard deviation, with the number of values as divisor.
  double deviation = min;
};

/// The statistics of the points [begin, end). Looks at each of them.
Statistics statistics(const Series& series, std::size_t begin, std::size_t end);

}  // namespace robotlink
