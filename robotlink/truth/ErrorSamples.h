// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace robotlink {

/// Amounts of an error, with their statistics. Memory is bounded: from a bound on every second sample counts,
/// then every fourth and so on, always the same ones. A plain value.
class ErrorSamples {
 public:
  static constexpr std::size_t kMaxKept = 1U << 16U;

  void add(double amount);

  /// How often add() was called.
  std::size_t count() const { return count_; }
  /// 0 without samples, as the functions below.
  double mean() const { return count_ == 0 ? 0 : sum_ / static_cast<double>(count_); }
  double maximum() const { return maximum_; }
  /// The newest one.
  double last() const { return last_; }
  /// The smallest kept sample that at least this share (0 to 1) of the kept ones does not exceed.
  double quantile(double share) const;

 private:
  std::size_t count_ = 0;
  double sum_ = 0, maximum_ = 0, last_ = 0;
  /// Each how many samples one is kept.
  std::size_t stride_ = 1;
  std::vector<float> kept_;
};

}  // namespace robotlink
