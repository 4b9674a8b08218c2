// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <optional>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Geometry.h"

namespace modules {

/// Where dead reckoning said that the robot was during the last seconds, so that what was measured can be
/// placed where the robot was when it was measured. Bounded.
class OdometryHistory {
 public:
  /// Instants must not decrease; an older one begins the history anew, and so does a step that no robot could
  /// have driven: the odometry was set to another place. Returns false then.
  bool add(robotlink::Instant time, const robotlink::Pose2& robotInOdometry);
  /// Interpolated between the two that are next to it, the nearest one beyond the ends. None if the history
  /// is empty, or if `time` is more than a second beyond one of its ends.
  std::optional<robotlink::Pose2> at(robotlink::Instant time) const;
  /// The last; none if there is none.
  std::optional<robotlink::Pose2> latest() const;
  bool empty() const { return entries_.empty(); }

 private:
  struct Entry {
    robotlink::Instant time;
    robotlink::Pose2 pose;
  };
  std::deque<Entry> entries_;
};

}  // namespace modules
