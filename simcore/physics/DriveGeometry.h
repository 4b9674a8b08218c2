// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simcore/physics/Footprint.h"
#include "simcore/world/WorldDescription.h"

namespace simcore {

/// What follows from where a drive's wheels are, in the model's frame.
struct DriveGeometry {
  Vector3 center = Vector3::Zero();   ///< between the wheels
  Vector3 toLeft = Vector3::UnitY();  ///< unit, along the axles
  double slipRatio = 1;               ///< see OdeWheels.h
  Footprint footprint;                ///< of all solids but the wheels, seen from the centre, x to the front
  double radius = 0;                  ///< of a circle about the centre that holds all solids, seen from above
};

/// The geometry of a model that has a drive.
DriveGeometry driveGeometry(const ModelDescription& model);

/// The ratio of slips that makes wheels at (+-a, +-b) turn about a track; 1 if they stand on one axle.
double slipRatioFor(double track, double a, double b);

}  // namespace simcore
