// SPDX-License-Identifier: GPL-3.0-or-later
// Models that move as they are commanded, as OdeWorld stores them; FollowingModels.h moves them.
#pragma once

#include <vector>

#include "robotlink/base/Geometry.h"

namespace simcore {

/// A model that moves in the plane as it is commanded; its servos turn its joints without any force.
struct OdeFollower {
  int model = 0;
  /// Whether it is commanded to move, over the ground; otherwise only its joints do, and it stays where it
  /// is.
  bool travels = true;
  /// The commanded velocity: m/s along its own axes, and rad/s.
  double ahead = 0, sideways = 0, turning = 0;
  /// Whether movable models are pushed; otherwise it stops at them, too.
  bool pushes = true;
  /// Whether something stopped it in the last step.
  bool stopped = false;
  /// Whether the members below describe how it stands; not at first, nor after it was moved by others.
  bool known = false;
  /// The model in the world: where it is in the plane, how it is turned there, and how it leans.
  robotlink::Pose2 place;
  Eigen::Matrix3d lean = Eigen::Matrix3d::Identity();
  double height = 0;
  /// The height of the ground below it, m: its lowest solid stays there.
  double ground = 0;
  /// Keyed by joint of the model: angle (rad) or position (m).
  std::vector<double> joints;
  /// Keyed by link of the model: where it is to be after this step. Wheels have none.
  std::vector<robotlink::Pose3> links;
};

}  // namespace simcore
