// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/world/RobotBody.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "foxglove/Scene.pb.h"
#include "robotlink/packages/Conversions.h"

namespace widgets {
namespace {

using robotlink::Pose3;
using robotlink::Vector3;

double angleOf(const RobotBody::Joint& joint, const JointAngles& angles) {
  const auto found = angles.find(joint.name);
  return found != angles.end() && std::isfinite(found->second) ? found->second : joint.usual;
}

double lowestPoint(const foxglove::SceneEntity& entity, const Pose3& part) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const auto& triangles : entity.triangles()) {
    const Pose3 pose = part * robotlink::pose3(triangles.pose());
    for (const auto& point : triangles.points())
      lowest = std::min(lowest, (pose * Vector3(point.x(), point.y(), point.z())).z());
  }
  return lowest;
}

}  // namespace

std::vector<Pose3> partsOnGround(const RobotBody& body, const JointAngles& angles) {
  // The transformation of each part by the joints above it, in the model's frame.
  std::vector<Pose3> moved(body.parts.size(), Pose3::Identity());
  for (const RobotBody::Joint& joint : body.joints) {
    const auto child = static_cast<std::size_t>(joint.child), parent = static_cast<std::size_t>(joint.parent);
    if (child >= moved.size() || (joint.parent >= 0 && parent >= moved.size())) continue;
    const Pose3 above = joint.parent < 0 ? Pose3::Identity() : moved[parent];
    const Eigen::Translation3d anchor(joint.anchor);
    moved[child] = above * anchor * Eigen::AngleAxisd(angleOf(joint, angles), joint.axis) * anchor.inverse();
  }
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < moved.size(); ++i) {
    moved[i] = moved[i] * body.parts[i];
    if (body.shapes && i < static_cast<std::size_t>(body.shapes->entities_size()))
      lowest = std::min(lowest, lowestPoint(body.shapes->entities(static_cast<int>(i)), moved[i]));
  }
  if (!std::isfinite(lowest)) return moved;
  for (Pose3& part : moved) part.pretranslate(Vector3(0, 0, -lowest));
  return moved;
}

}  // namespace widgets
