// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/packages/Packages.h"

namespace foxglove {
class Grid;
}  // namespace foxglove

namespace robotcontrol {
class GripperState;
}

namespace robotlink {

/// The occupancy grid that the robot has mapped so far; see Grid.proto.
inline constexpr Package<foxglove::Grid> kGridMap{"models/map"};
/// The state of a gripper that the robot carries, from its platform.
inline constexpr Package<robotcontrol::GripperState> kGripper{"body/gripper"};

}  // namespace robotlink
