// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "robotlink/base/Geometry.h"

namespace robotlink::arcos {

// The arguments of commands: lengths and speeds in mm and mm/s, angles and rotations in deg and deg/s.

inline int inMillimeters(double meters) {
  return static_cast<int>(std::lround(meters * 1000));
}
inline int inDegrees(double angle) {
  return static_cast<int>(std::lround(degrees(angle)));
}

}  // namespace robotlink::arcos
