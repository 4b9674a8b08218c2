// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <utility>

#include "robotlink/base/Geometry.h"

namespace widgets {

/// The speed of a hand, from the places where it was in the last tenth of a second. A plain value.
class HandSpeed {
 public:
  /// `time`: ms; must not decrease.
  void add(std::uint64_t time, const robotlink::Vector2& place) {
    places_.emplace_back(time, place);
    while (places_.size() > 2 && places_.front().first + kWindow < time) places_.pop_front();
  }
  /// In the unit of the places per s; 0 for a hand that was at rest before `time`.
  robotlink::Vector2 at(std::uint64_t time) const {
    if (places_.size() < 2 || places_.back().first + kRest < time) return robotlink::Vector2::Zero();
    const std::uint64_t passed = places_.back().first - places_.front().first;
    if (passed == 0 || passed > kWindow + kRest) return robotlink::Vector2::Zero();
    return (places_.back().second - places_.front().second) / (static_cast<double>(passed) / 1000);
  }

 private:
  static constexpr std::uint64_t kWindow = 100, kRest = 60;  // ms
  std::deque<std::pair<std::uint64_t, robotlink::Vector2>> places_;
};

}  // namespace widgets
