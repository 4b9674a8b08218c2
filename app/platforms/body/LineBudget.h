// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/base/Clock.h"

namespace app {

/// The bytes per second that may be sent over a line without queuing up in it: commands that answer
/// readings are too late behind a queue, on a line that could carry them in time. What the queue costs is the
/// time by which a round trip takes longer than the shortest one. A plain value.
class LineBudget {
 public:
  /// Call this when a round trip was measured, with the bytes received meanwhile per second.
  void measured(robotlink::Duration roundTrip, double bytesPerSecond);
  /// In bytes a second; 0: as much as is sent.
  double bytesPerSecond() const { return budget_; }

  /// The queue from which on less is sent, and below which more is.
  static constexpr robotlink::Duration kTooLong = std::chrono::milliseconds(120),
                                       kShort = std::chrono::milliseconds(50);
  /// In bytes a second: what sensor readings without images need.
  static constexpr double kLeast = 20'000;

 private:
  /// The shortest round trip of this line.
  robotlink::Duration shortest_ = robotlink::Duration::max();
  /// Whether the last one was.
  bool isLong_ = false;
  double budget_ = 0;
};

}  // namespace app
