// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace widgets {

struct ViewContext;

/// Attaches the commands for manual control ("robot.take-over", "robot.walk", "robot.motion", ...) to the
/// context's command table. They act on manualSteering(context), as the motion view does, and fail when it no
/// longer exists. Does nothing if they are attached already.
void attachMotionCommands(ViewContext& context);

}  // namespace widgets
