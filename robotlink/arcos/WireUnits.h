// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "robotlink/base/Geometry.h"

namespace robotlink::arcos {

// The arguments of commands: lengths and speeds in mm and mm/s, angles and rotations in deg and deg/s.

/// The nearest whole number; 0 for what is not finite. What is beyond any command's range stays beyond it.
inline int wholeNumber(double value) {
  constexpr double kMax = 1e6;
  return std::isfinite(value) ? static_cast<int>(std::lround(std::clamp(value, -kMax, kMax))) : 0;
}
inline int inMillimeters(double meters) {
  return wholeNumber(meters * 1000);
}
inline int inDegrees(double angle) {
  return wholeNumber(degrees(angle));
}

}  // namespace robotlink::arcos
