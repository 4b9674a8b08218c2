// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "robotlink/base/Clock.h"

namespace robotlink::websocket {

/// A limit of units (bytes, messages) a second, with a tenth of a second saved up at most (a token bucket).
/// An amount larger than the rest may be taken whole; it is paid for afterward.
class Allowance {
 public:
  /// 0 means without limit. Begins with what may be saved up.
  void setRate(double unitsPerSecond) {
    rate_ = unitsPerSecond;
    left_ = maxSaved();
  }
  double rate() const { return rate_; }

  bool isReady(Instant now) {
    if (rate_ <= 0) return true;
    left_ = std::min(left_ + seconds(std::max(now - at_, Duration::zero())) * rate_, maxSaved());
    at_ = now;
    return left_ > 0;
  }
  void take(std::size_t units) {
    if (rate_ > 0) left_ -= static_cast<double>(units);
  }

 private:
  double maxSaved() const { return std::max(rate_ / 10, 1.0); }

  double rate_ = 0, left_ = 0;
  Instant at_;
};

}  // namespace robotlink::websocket
