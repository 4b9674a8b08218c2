// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace widgets {

/// Extremes, mean and standard deviation of any number of periods, in constant memory. The deviation is
/// updated with each value (B. P. Welford, "Note on a method for calculating corrected sums of squares and
/// products", 1962), so that long runs lose no digits. A plain value; seconds.
class PeriodStatistics {
 public:
  /// Values that are not finite are ignored.
  void add(double seconds);

  std::uint64_t count() const { return count_; }
  /// All are 0 if nothing was added.
  double minimum() const { return minimum_; }
  double maximum() const { return maximum_; }
  double mean() const { return mean_; }
  /// The standard deviation of those that were added; 0 for a single one.
  double deviation() const;

 private:
  std::uint64_t count_ = 0;
  double minimum_ = 0, maximum_ = 0, mean_ = 0;
  /// The sum of the squared distances from the mean.
  double squares_ = 0;
};

}  // namespace widgets
