// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace robotcontrol {
class DriveState;
}

namespace widgets {

struct RobotBelief;

/// What to do so that a robot on wheels finds out where it is on the map; empty once it knows. `base`: what
/// it says of itself, null: nothing yet.
QString placeNotice(const RobotBelief& robot, const robotcontrol::DriveState* base, bool onMap);

}  // namespace widgets
