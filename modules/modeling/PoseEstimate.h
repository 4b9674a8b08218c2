// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/base/Geometry.h"

namespace modules {

/// Where the robot believes to be on the field, or in the building.
struct PoseEstimate {
  robotlink::Pose2 robotInField;
  double positionDeviation = 0;  ///< m, standard deviation
  double headingDeviation = 0;   ///< rad, standard deviation
};

}  // namespace modules
