// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timing/PeriodStatistics.h"

#include <algorithm>
#include <cmath>

namespace widgets {

void PeriodStatistics::add(double seconds) {
  if (!std::isfinite(seconds)) return;
  minimum_ = count_ == 0 ? seconds : std::min(minimum_, seconds);
  maximum_ = count_ == 0 ? seconds : std::max(maximum_, seconds);
  ++count_;
  const double before = seconds - mean_;
  mean_ += before / static_cast<double>(count_);
  squares_ += before * (seconds - mean_);
}

double PeriodStatistics::deviation() const {
  return count_ > 0 ? std::sqrt(squares_ / static_cast<double>(count_)) : 0;
}

}  // namespace widgets
