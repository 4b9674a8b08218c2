// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <optional>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Geometry.h"

namespace modules {

/// The poses by dead reckoning during the last seconds, to locate measurements where the robot was at their
/// time. Bounded. Not thread-safe.
class OdometryHistory {
 public:
  /// Adds a pose. Instants must not decrease: an older one restarts the history, and so does a step that no
  /// robot could have driven, because the odometry was reset. Returns false in both cases.
  bool add(robotlink::Instant time, const robotlink::Pose2& robotInOdometry);
  /// The pose at an instant, interpolated between its two neighbors, or the nearest one beyond the ends.
  /// Empty if the history is empty, or if `time` is more than a second beyond one of its ends.
  std::optional<robotlink::Pose2> at(robotlink::Instant time) const;
  /// The latest pose; empty if there is none.
  std::optional<robotlink::Pose2> latest() const;
  bool empty() const { return entries_.empty(); }

 private:
  struct Entry {
    robotlink::Instant time;
    robotlink::Pose2 pose;
  };
  /// Oldest first.
  std::deque<Entry> entries_;
};

}  // namespace modules
