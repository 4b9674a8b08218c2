// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"
#include "simcore/world/RenderScene.h"

namespace simcore {

/// The visible parts and joints of a robot from its model file: for viewers that know the
/// angles of its joints but have no simulation. A plain value; meters and radians in the model's frame, with
/// all joints at 0.
struct ModelParts {
  /// A hinge or a rigid connection.
  struct Joint {
    std::string name;
    /// Indices of links; the parent -1 is the model itself.
    int parent = -1, child = 0;
    Eigen::Vector3d anchor = Eigen::Vector3d::Zero();
    Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
    /// The angle of the joint at the start of a simulation.
    double usual = 0;
  };
  /// The poses of the links.
  std::vector<Pose3> links;
  /// The joints; a parent's joint comes before those of its children.
  std::vector<Joint> joints;
  /// The shapes of the links; link i is body i + 1.
  std::shared_ptr<const RenderScene> shapes;

  /// Reads the shipped model of this name ("ers210"), in the color of a team if it has parts in that color.
  /// Fails if there is no such model, if it is damaged, or if it is no robot. Takes some 100 ms. Any thread.
  static tl::expected<ModelParts, robotlink::Errors> load(const std::string& model, std::optional<Rgb> team);
};

}  // namespace simcore
