// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/PastValues.h"

#include <limits>

namespace widgets {

using robotlink::Series;

namespace {

/// This many more, and half as many again as before, count as a large increase.
constexpr std::size_t kMinIncrease = 1000;

}  // namespace

void PastValues::note(const Point& point, bool isFiltered) {
  if (!begin_) begin_ = point.time;
  const bool isNeeded = isFiltered && (!isDecided_ || values_);
  if (!isNeeded) return;
  raw_.append(point);
  raw_.limit(kMaxBytes);
}

void PastValues::read(std::shared_ptr<const LoggedCurve> values) {
  isDecided_ = true;
  values_ = std::move(values);
}

void PastValues::skip() {
  isDecided_ = true;
  raw_.clear();
}

bool PastValues::mergeInto(Series& live, robotlink::PointFilter& filter) {
  if (!values_ || !begin_) return false;
  const Series& past = values_->series;
  const bool isComplete = values_->isComplete;
  if (!isComplete && past.size() < merged_ + merged_ / 2 + kMinIncrease) return false;
  robotlink::PointFilter again = filter;
  again.restart();
  Series all;
  const auto add = [&](const Point& point) {
    if (const auto result = again.next(point)) all.append(*result);
  };
  for (std::size_t i = 0; i < past.size() && past[i].time < *begin_; ++i) {
    add(past[i]);
    reached_ = past[i].time;
  }
  merged_ = past.size();
  if (filter.isEmpty()) {
    for (std::size_t i = live.firstFrom(*begin_); i < live.size(); ++i) all.append(live[i]);
  } else {
    for (std::size_t i = 0; i < raw_.size(); ++i) add(raw_[i]);
    filter = std::move(again);
  }
  live = std::move(all);
  if (isComplete) {
    values_.reset();
    raw_.clear();
  }
  return true;
}

std::optional<std::pair<double, double>> PastValues::unread() const {
  if (!begin_ || (isDecided_ && !values_)) return std::nullopt;
  return std::pair(reached_.value_or(-std::numeric_limits<double>::infinity()), *begin_);
}

}  // namespace widgets
