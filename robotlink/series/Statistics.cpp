// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/series/Statistics.h"

#include <cmath>

namespace robotlink {

Statistics statistics(const Series& series, std::size_t begin, std::size_t end) {
  // B. P. Welford, Note on a Method for Calculating Corrected Sums of Squares and Products, 1962.
  double mean = 0, squares = 0;
  Statistics all;
  for (std::size_t i = begin; i < end; ++i) {
    const double value = series[i].value;
    if (std::isnan(value)) continue;
    ++all.count;
    const double before = value - mean;
    mean += before / static_cast<double>(all.count);
    squares += before * (value - mean);
  }
  if (all.count == 0) return all;
  const Series::Extent extent = series.extent(begin, end);
  all.min = extent.min;
  all.max = extent.max;
  all.mean = mean;
  all.deviation = std::sqrt(squares / static_cast<double>(all.count));
  return all;
}

}  // namespace robotlink
