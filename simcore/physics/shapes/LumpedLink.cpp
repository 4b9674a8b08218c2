// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/physics/shapes/LumpedLink.h"

#include <algorithm>

namespace simcore {
namespace {

/// The inertia of a mass about a point at `offset` from its center of mass.
Eigen::Matrix3d shiftedInertia(const Eigen::Matrix3d& inertia, double mass, const Vector3& offset) {
  return inertia + mass * (offset.squaredNorm() * Eigen::Matrix3d::Identity() - offset * offset.transpose());
}

}  // namespace

bool isWheel(const ModelDescription& model, int link) {
  return std::ranges::any_of(
      model.joints, [&](const JointDescription& joint) { return joint.wheel && joint.child == link; });
}

LinkDescription withWheelsLumped(const ModelDescription& model, int link) {
  LinkDescription result = model.links[static_cast<std::size_t>(link)];
  const LinkDescription own = result;
  struct Piece {
    double mass;
    // In the link's frame.
    Vector3 center;
    Eigen::Matrix3d inertia;
  };
  std::vector<Piece> pieces = {{own.mass, own.centerOfMass, own.inertia}};
  for (const JointDescription& joint : model.joints) {
    if (!joint.wheel || joint.parent != link) continue;
    const LinkDescription& wheel = model.links[static_cast<std::size_t>(joint.child)];
    const Pose3 wheelInLink = own.poseInModel.inverse() * wheel.poseInModel;
    const Eigen::Matrix3d rotation = wheelInLink.linear();
    pieces.push_back(
        {wheel.mass, wheelInLink * wheel.centerOfMass, rotation * wheel.inertia * rotation.transpose()});
  }
  if (pieces.size() == 1) return result;
  result.mass = 0;
  Vector3 moment = Vector3::Zero();
  for (const Piece& piece : pieces) {
    result.mass += piece.mass;
    moment += piece.mass * piece.center;
  }
  result.centerOfMass = moment / result.mass;
  result.inertia.setZero();
  for (const Piece& piece : pieces) {
    result.inertia += shiftedInertia(piece.inertia, piece.mass, piece.center - result.centerOfMass);
  }
  return result;
}

}  // namespace simcore
