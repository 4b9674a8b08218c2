// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "robotlink/base/Geometry.h"

namespace simcore {

/// A contact of two solids in the last step. Links are named by their paths ("red1/link:body"), and models
/// that never move by their names. SI units, in the world's frame.
struct ContactForce {
  std::string first, second;
  robotlink::Vector3 point = robotlink::Vector3::Zero();
  /// A unit vector toward the first.
  robotlink::Vector3 normal = robotlink::Vector3::Zero();
  /// How far they overlap, m.
  double depth = 0;
  /// The force on the first, friction included.
  robotlink::Vector3 force = robotlink::Vector3::Zero();
};

/// The reaction of a hinge or a slider on its child in the last step.
struct JointForce {
  /// The path of the joint: "red1/joint:legFL1".
  std::string joint;
  robotlink::Vector3 anchor = robotlink::Vector3::Zero();
  robotlink::Vector3 force = robotlink::Vector3::Zero();
  /// The torque about the anchor.
  robotlink::Vector3 torque = robotlink::Vector3::Zero();
};

/// A force that a user applies by hand.
struct HandForce {
  enum class Kind : std::uint8_t { kDrag, kPush };
  Kind kind = Kind::kDrag;
  /// The path of the link.
  std::string link;
  /// The point on which the force acts, and for kDrag the one to which it pulls.
  robotlink::Vector3 point = robotlink::Vector3::Zero(), target = robotlink::Vector3::Zero();
  robotlink::Vector3 force = robotlink::Vector3::Zero();
};

/// The forces in a world in its last step. A plain value.
struct Forces {
  std::vector<ContactForce> contacts;
  std::vector<JointForce> joints;
  std::vector<HandForce> hands;
};

}  // namespace simcore
