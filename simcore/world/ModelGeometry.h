// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "simcore/world/WorldDescription.h"

namespace simcore {

/// How a joint at its initial position has moved its child, in the model's frame with all joints at 0.
Pose3 displacementAtStart(const JointDescription& joint);
/// The poses of a model's links with its joints at these angles (rad) or positions (m), by link.
std::vector<Pose3> linksAt(const ModelDescription& model, std::span<const double> positions);
/// The poses of a model's links with all joints at their initial angles, by link.
std::vector<Pose3> linksAtStart(const ModelDescription& model);

/// The support function of a shape that is centered at the origin: how far it extends in a direction of unit
/// length, m. Planes have no extent.
double reach(const Shape& shape, const Eigen::Matrix3d& shapeInFrame, const Vector3& direction);

/// The upright cylinder around a model's z-axis that contains all its solids, with all joints at their
/// initial angles.
struct ModelExtent {
  double radius = 0;
  /// In the model's frame, m.
  double low = 0, high = 0;
};
/// All zero if the model has no solids.
ModelExtent extentOf(const ModelDescription& model);

}  // namespace simcore
