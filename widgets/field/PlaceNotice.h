// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace robotcontrol {
class DriveState;
}

namespace widgets {

struct RobotBelief;

/// Returns advice for the user on how a robot on wheels can localize itself on the map; empty once it has.
/// `base`: the robot's DriveState, null: none was received. `onMap`: a map is shown.
QString placeNotice(const RobotBelief& robot, const robotcontrol::DriveState* base, bool onMap);

}  // namespace widgets
