// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/truth/ErrorSamples.h"

#include <algorithm>
#include <cmath>

namespace robotlink {

void ErrorSamples::add(double amount) {
  if (!std::isfinite(amount)) return;
  sum_ += amount;
  last_ = amount;
  maximum_ = count_ == 0 ? amount : std::max(maximum_, amount);
  if (count_++ % stride_ != 0) return;
  kept_.push_back(static_cast<float>(amount));
  if (kept_.size() < kMaxKept) return;
  for (std::size_t i = 0; 2 * i < kept_.size(); ++i) kept_[i] = kept_[2 * i];
  kept_.resize((kept_.size() + 1) / 2);
  stride_ *= 2;
}

double ErrorSamples::quantile(double share) const {
  if (kept_.empty()) return 0;
  std::vector<float> sorted = kept_;
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size())));
  const auto nth =
      sorted.begin() + static_cast<std::ptrdiff_t>(std::clamp<std::size_t>(rank, 1, sorted.size()) - 1);
  std::ranges::nth_element(sorted, nth);
  return static_cast<double>(*nth);
}

}  // namespace robotlink
