// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstdint>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Error.h"

namespace widgets {

struct ViewContext;

/// The source of captured joint angles: measured by the robot, or requested by its program.
enum class PoseSource : std::uint8_t { kMeasured, kRequested };

/// Adds the pose of the selected robot at the instant of the timeline to the motion in the editor, as a key
/// frame after the selected one that is reached in `duration`; starts a motion with all joints of the robot
/// if there is none. Returns what was done, for the user. Fails if angles are unknown.
robotlink::Result<QString> capturePose(ViewContext& context, PoseSource source, robotlink::Duration duration);

}  // namespace widgets
