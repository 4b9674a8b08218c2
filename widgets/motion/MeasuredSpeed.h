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

/// The speed of a robot in its own frame.
struct Speed {
  /// The forward speed, m/s.
  double x = 0;
  /// m/s, to the left.
  double y = 0;
  /// rad/s, counterclockwise.
  double rotation = 0;
};

/// The mean speed between two poses in the field's frame that are `elapsed` apart, in the frame of the pose
/// halfway between them. `elapsed` must not be 0.
Speed speedBetween(const robotlink::Pose2& before, const robotlink::Pose2& after,
                   robotlink::Duration elapsed);

/// The true mean speed of a robot in the `window` before `time`, from its poses in the stream "transforms".
/// Unset if true poses are not published (real robots) or the history is shorter than half the window.
std::optional<Speed> measuredSpeed(const robotlink::StreamStore& store, const std::string& robot,
                                   robotlink::Instant time,
                                   robotlink::Duration window = std::chrono::milliseconds(500));

}  // namespace widgets
