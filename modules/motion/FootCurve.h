// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/motion/GaitParameters.h"

namespace modules {

/// The position of a paw on its closed curve: `along` its step vector from -0.5 (rear) to 0.5 (front), and
/// `up` as a fraction of the full lift, 0 to 1.
struct FootPoint {
  double along = 0, up = 0;
};

/// The shape of a paw's curve over time. It starts at the front on the ground; the paw is on the ground in
/// phases [0, ground).
struct FootCurve {
  FootMode mode = FootMode::kRectangle;
  /// Fractions of the cycle.
  double ground = 0.5, lift = 0.06, lowering = 0.06;

  /// `phase` is in [0, 1). The curve is continuous, also from 1 to 0.
  FootPoint at(double phase) const;
};

}  // namespace modules
