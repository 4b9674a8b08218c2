// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <deque>

#include "robotlink/base/Geometry.h"

namespace modules {

/// The poses by dead reckoning of the last seconds, so that an image is combined with the pose that the robot
/// had when the image was taken. A plain value; not thread-safe.
class OdometryBuffer {
 public:
  /// Times in s of any clock; poses that are not newer than the last one are ignored.
  void add(double time, const robotlink::Pose2& robotInOdometry) {
    if (!poses_.empty() && time <= poses_.back().time) return;
    poses_.push_back({time, robotInOdometry});
    while (poses_.size() > kMaxPoses) poses_.pop_front();
  }
  /// The pose at a time, interpolated; the first or the last one outside of the known times, and 0 if none is
  /// known.
  robotlink::Pose2 at(double time) const {
    if (poses_.empty()) return {};
    const auto later = std::ranges::lower_bound(poses_, time, {}, &Stamped::time);
    if (later == poses_.end()) return poses_.back().pose;
    if (later == poses_.begin()) return poses_.front().pose;
    const Stamped &a = *std::prev(later), &b = *later;
    const double share = (time - a.time) / (b.time - a.time);
    const robotlink::Pose2 step = a.pose.inverse() * b.pose;
    return a.pose * robotlink::Pose2{share * step.x, share * step.y, share * step.heading};
  }

 private:
  struct Stamped {
    double time = 0;
    robotlink::Pose2 pose;
  };
  static constexpr std::size_t kMaxPoses = 100;

  std::deque<Stamped> poses_;
};

}  // namespace modules
