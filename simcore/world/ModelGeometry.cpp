// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/world/ModelGeometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace simcore {

namespace {

Pose3 displacementAt(const JointDescription& joint, double position) {
  if (joint.kind == JointDescription::Kind::kSlider)
    return Pose3(Eigen::Translation3d(position * joint.axisInModel));
  const Eigen::Translation3d anchor(joint.anchorInModel);
  return anchor * Eigen::AngleAxisd(position, joint.axisInModel) * anchor.inverse();
}

}  // namespace

Pose3 displacementAtStart(const JointDescription& joint) {
  return displacementAt(joint, joint.initialAngle);
}

std::vector<Pose3> linksAt(const ModelDescription& model, std::span<const double> positions) {
  // Keyed by the joints above, in the model's frame.
  std::vector<Pose3> moved(model.links.size(), Pose3::Identity());
  // Joints of parents come before those of their children.
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const JointDescription& joint = model.joints[i];
    if (joint.closesCycle) continue;
    const Pose3 above = joint.parent < 0 ? Pose3::Identity() : moved[static_cast<std::size_t>(joint.parent)];
    moved[static_cast<std::size_t>(joint.child)] = above * displacementAt(joint, positions[i]);
  }
  for (std::size_t i = 0; i < moved.size(); ++i) moved[i] = moved[i] * model.links[i].poseInModel;
  return moved;
}

std::vector<Pose3> linksAtStart(const ModelDescription& model) {
  std::vector<double> positions;
  for (const JointDescription& joint : model.joints) positions.push_back(joint.initialAngle);
  return linksAt(model, positions);
}

double reach(const Shape& shape, const Eigen::Matrix3d& shapeInFrame, const Vector3& direction) {
  const Vector3 local = shapeInFrame.transpose() * direction;
  switch (shape.kind) {
    case Shape::Kind::kBox:
      return local.cwiseAbs().dot(shape.size) / 2;
    case Shape::Kind::kSphere:
      return shape.radius;
    case Shape::Kind::kCylinder:
      return std::abs(local.z()) * shape.length / 2 + local.head<2>().norm() * shape.radius;
    case Shape::Kind::kCapsule:
      return std::abs(local.z()) * shape.length / 2 + shape.radius;
    case Shape::Kind::kMesh: {
      double farthest = 0;
      for (const Eigen::Vector3f& vertex : shape.mesh->vertices)
        farthest = std::max(farthest, local.dot(vertex.cast<double>()));
      return farthest;
    }
    case Shape::Kind::kPlane:
      break;
  }
  return 0;
}

ModelExtent extentOf(const ModelDescription& model) {
  constexpr int kDirections = 64;
  const std::vector<Pose3> links = linksAtStart(model);
  ModelExtent extent{0, std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()};
  for (std::size_t i = 0; i < links.size(); ++i) {
    for (const CollisionDescription& collision : model.links[i].collisions) {
      const Pose3 pose = links[i] * collision.poseInLink;
      const auto farthest = [&](const Vector3& direction) {
        return direction.dot(pose.translation()) + reach(collision.shape, pose.linear(), direction);
      };
      extent.high = std::max(extent.high, farthest(Vector3::UnitZ()));
      extent.low = std::min(extent.low, -farthest(-Vector3::UnitZ()));
      for (int k = 0; k < kDirections; ++k) {
        const double angle = 2 * robotlink::kPi * k / kDirections;
        extent.radius = std::max(extent.radius, farthest({std::cos(angle), std::sin(angle), 0}));
      }
    }
  }
  return extent.low <= extent.high ? extent : ModelExtent{};
}

}  // namespace simcore
