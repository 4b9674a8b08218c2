// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/base/Geometry.h"

namespace modules {

/// The pose estimate of the robot, on a field or in a building.
struct PoseEstimate {
  robotlink::Pose2 robotInField;
  double positionDeviation = 0;  ///< m, standard deviation
  double headingDeviation = 0;   ///< rad, standard deviation
};

}  // namespace modules
