// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace robotcontrol {
class DriveState;
}

namespace widgets {

struct RobotBelief;

/// What the user should do so that a robot on wheels finds its pose on the map; empty once it knows it.
/// `base`: the robot's DriveState, null: none was received. `onMap`: a map is shown.
QString placeNotice(const RobotBelief& robot, const robotcontrol::DriveState* base, bool onMap);

}  // namespace widgets
