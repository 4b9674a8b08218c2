// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/motion/FootCurve.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace modules {

FootPoint FootCurve::at(double phase) const {
  if (phase < ground) return {0.5 - phase / ground, 0};
  const double air = 1 - ground;
  if (mode == FootMode::kHalfEllipse) {
    const double angle = std::numbers::pi * (phase - ground) / air;
    return {-0.5 * std::cos(angle), std::sin(angle)};
  }
  const double inAir = phase - ground;
  if (inAir < lift) return {-0.5, inAir / lift};
  if (inAir > air - lowering) return {0.5, std::max(0.0, (1 - phase) / lowering)};
  return {-0.5 + (inAir - lift) / std::max(air - lift - lowering, 1e-9), 1};
}

}  // namespace modules
