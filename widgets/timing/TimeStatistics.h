// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

namespace widgets {

/// Statistics of any number of durations in bounded memory (some 5 kB): extremes and mean are exact,
/// percentiles are within 1 %, because values are counted in buckets each of which is 2 % wider than the one
/// before. A plain value; seconds.
class TimeStatistics {
 public:
  /// Durations from 100 ns to 1000 s; what is beyond counts as the nearest of these in percentiles.
  void add(double seconds);

  std::uint64_t count() const { return count_; }
  /// All are 0 if nothing was added.
  double last() const { return last_; }
  double mean() const { return count_ > 0 ? sum_ / static_cast<double>(count_) : 0; }
  double minimum() const { return minimum_; }
  double maximum() const { return maximum_; }
  /// The duration that a share (0 to 1) of all do not exceed: 0.5 gives the median.
  double percentile(double share) const;

 private:
  std::uint64_t count_ = 0;
  double sum_ = 0, minimum_ = 0, maximum_ = 0, last_ = 0;
  /// The number of values in each bucket; made with the first one.
  std::vector<std::uint32_t> buckets_;
};

}  // namespace widgets
