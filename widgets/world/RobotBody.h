// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "robotlink/base/Geometry.h"

namespace foxglove {
class SceneUpdate;
}

namespace widgets {

/// The parts of a kind of robot and its joints, by which a view shows a robot that no scene shows. Immutable;
/// meters and radians in the frame of the model, with all joints at 0.
struct RobotBody {
  struct Joint {
    std::string name;
    /// Indices of parts; the parent -1 is the model itself.
    int parent = -1, child = 0;
    robotlink::Vector3 anchor = robotlink::Vector3::Zero();
    robotlink::Vector3 axis = robotlink::Vector3::UnitZ();
    /// Its angle where none is known.
    double usual = 0;
  };
  /// Their poses.
  std::vector<robotlink::Pose3> parts;
  /// The joints; a parent's joint comes before those of its children.
  std::vector<Joint> joints;
  /// The visible shapes: entity i is part i, in the frame of that part.
  std::shared_ptr<const foxglove::SceneUpdate> shapes;
};

/// Angles by the joints' names.
using JointAngles = std::map<std::string, double>;

/// The poses of the parts in the frame on the ground below the robot, which stands upright: its lowest point
/// touches the ground. Angles that are missing or not finite are the usual ones. Costs as much as moving all
/// points of its shapes. Pure.
std::vector<robotlink::Pose3> partsOnGround(const RobotBody& body, const JointAngles& angles);

}  // namespace widgets
