// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/core/platform/HeadlessRun.h"

namespace app {

/// How a robot at the other end of a line runs without a window: its program runs here in real time until the
/// time is over or the user interrupts it. The state of the connection is printed. The run fails if the robot
/// was never connected.
HeadlessPlatform headlessPioneer();

}  // namespace app
