// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simcore/physics/shapes/Footprint.h"
#include "simcore/world/WorldDescription.h"

namespace simcore {

/// Quantities that follow from the positions of a drive's wheels, in the model's frame.
struct DriveGeometry {
  /// The middle between the wheels.
  Vector3 center = Vector3::Zero();
  /// Unit vector along the axles.
  Vector3 toLeft = Vector3::UnitY();
  /// See OdeWheels.h.
  double slipRatio = 1;
  /// Footprint of all solids but the wheels, relative to the center, x to the front.
  Footprint footprint;
  /// Radius of the circle around the center that contains all solids, seen from above.
  double radius = 0;
};

/// Computes the geometry of a model with a drive, with its joints at their initial angles.
DriveGeometry driveGeometry(const ModelDescription& model);

/// The ratio of slips with which wheels at (+-a, +-b) turn as if they had this track; 1 if they are on one
/// axle.
double slipRatioFor(double track, double a, double b);

}  // namespace simcore
