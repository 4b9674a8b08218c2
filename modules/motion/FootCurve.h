// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/motion/GaitParameters.h"

namespace modules {

/// Where a paw is on its closed curve: `along` its step vector, from -0.5 (behind) to 0.5 (before), and how
/// much of the full lift it is `up`, 0 to 1.
struct FootPoint {
  double along = 0, up = 0;
};

/// The shape of a leg's curve over time. The curve begins in front, on the ground: phases [0, ground) are on
/// the ground.
struct FootCurve {
  FootMode mode = FootMode::kRectangle;
  double ground = 0.5, lift = 0.06, lowering = 0.06;  ///< shares of the cycle

  /// `phase` in [0, 1). Continuous, also from 1 to 0.
  FootPoint at(double phase) const;
};

}  // namespace modules
