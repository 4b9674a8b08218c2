// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/navigation/OdometryHistory.h"

#include <algorithm>

namespace modules {

using robotlink::Duration;
using robotlink::Instant;
using robotlink::Pose2;

namespace {

constexpr Duration kMemory = std::chrono::seconds(3);
constexpr Duration kBeyond = std::chrono::seconds(1);
constexpr std::size_t kMax = 1000;
// No robot of this program is faster; the constant part is for late timestamps.
constexpr double kMaxSpeed = 3;
constexpr double kMaxStep = 0.5;

}  // namespace

bool OdometryHistory::add(Instant time, const Pose2& robotInOdometry) {
  bool continued = true;
  if (!entries_.empty()) {
    const Entry& last = entries_.back();
    const double way = (robotInOdometry.translation() - last.pose.translation()).norm();
    continued = time >= last.time && way <= kMaxStep + kMaxSpeed * robotlink::seconds(time - last.time);
    if (!continued) entries_.clear();
  }
  entries_.push_back({time, robotInOdometry});
  while (entries_.size() > kMax || entries_.front().time + kMemory < time) entries_.pop_front();
  return continued;
}

std::optional<Pose2> OdometryHistory::at(Instant time) const {
  if (entries_.empty() || time + kBeyond < entries_.front().time || time > entries_.back().time + kBeyond)
    return std::nullopt;
  const auto after = std::ranges::lower_bound(entries_, time, {}, &Entry::time);
  if (after == entries_.end()) return entries_.back().pose;
  if (after == entries_.begin() || after->time == time) return after->pose;
  const Entry& before = *(after - 1);
  const double share = robotlink::seconds(time - before.time) / robotlink::seconds(after->time - before.time);
  const Pose2 step = before.pose.inverse() * after->pose;
  return before.pose * Pose2{share * step.x, share * step.y, share * step.heading};
}

std::optional<Pose2> OdometryHistory::latest() const {
  if (entries_.empty()) return std::nullopt;
  return entries_.back().pose;
}

}  // namespace modules
