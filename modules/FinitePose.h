// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "robotlink/base/Geometry.h"

namespace modules {

/// Whether a pose of a message can be computed with: all of its values are finite numbers.
inline bool isFinite(const robotlink::Pose2& pose) {
  return std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.heading);
}

}  // namespace modules
