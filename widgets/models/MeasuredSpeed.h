// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Geometry.h"

namespace robotlink {
class StreamStore;
}

namespace widgets {

/// How a robot moves, in its own frame.
struct Speed {
  double x = 0;         ///< m/s, forwards
  double y = 0;         ///< m/s, to the left
  double rotation = 0;  ///< rad/s, counter-clockwise
};

/// The mean speed between two poses in the field that lie `elapsed` apart, in the frame of the pose halfway.
Speed speedBetween(const robotlink::Pose2& before, const robotlink::Pose2& after,
                   robotlink::Duration elapsed);

/// How fast the robot truly moved in the `window` before `time`, from its poses in the stream "transforms".
/// Nothing if the session does not know true poses or the history is shorter than half the window.
std::optional<Speed> measuredSpeed(const robotlink::StreamStore& store, const std::string& robot,
                                   robotlink::Instant time,
                                   robotlink::Duration window = std::chrono::milliseconds(500));

}  // namespace widgets
