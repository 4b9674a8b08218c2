// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timing/TimeStatistics.h"

#include <algorithm>
#include <cmath>

namespace widgets {
namespace {

constexpr double kFirstBucket = 1e-7;  // s
constexpr double kBucketGrowth = 1.02;
constexpr double kMaxTime = 1000;  // s

std::size_t bucketOf(double seconds) {
  const double within = std::clamp(seconds, kFirstBucket, kMaxTime);
  return static_cast<std::size_t>(std::log(within / kFirstBucket) / std::log(kBucketGrowth));
}

/// The middle of a bucket.
double timeOf(std::size_t bucket) {
  return kFirstBucket * std::pow(kBucketGrowth, static_cast<double>(bucket) + 0.5);
}

}  // namespace

void TimeStatistics::add(double seconds) {
  if (!std::isfinite(seconds)) return;
  minimum_ = count_ == 0 ? seconds : std::min(minimum_, seconds);
  maximum_ = count_ == 0 ? seconds : std::max(maximum_, seconds);
  sum_ += seconds;
  last_ = seconds;
  ++count_;
  if (buckets_.empty()) buckets_.resize(bucketOf(kMaxTime) + 1);
  ++buckets_[bucketOf(seconds)];
}

double TimeStatistics::percentile(double share) const {
  const double wanted = std::ceil(std::clamp(share, 0.0, 1.0) * static_cast<double>(count_));
  double below = 0;
  for (std::size_t i = 0; i < buckets_.size(); ++i) {
    below += buckets_[i];
    if (buckets_[i] > 0 && below >= wanted) return std::clamp(timeOf(i), minimum_, maximum_);
  }
  return maximum_;
}

}  // namespace widgets
