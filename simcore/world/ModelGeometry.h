// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "simcore/world/WorldDescription.h"

namespace simcore {

/// Where a model's links are in it with all joints at their initial angles, by link.
std::vector<Pose3> linksAtStart(const ModelDescription& model);

/// How far a shape, whose centre is the origin, reaches in a direction of unit length, m: its support
/// function. Planes and pictures reach nowhere.
double reach(const Shape& shape, const Eigen::Matrix3d& shapeInFrame, const Vector3& direction);

/// The upright cylinder about a model's z-axis that holds all its solids at the start.
struct ModelExtent {
  double radius = 0;
  double low = 0, high = 0;  ///< in the model
};
ModelExtent extentOf(const ModelDescription& model);

}  // namespace simcore
