// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "robotlink/base/Geometry.h"

namespace simcore {

/// The state of the world that a future image of a delayed camera will show. A copy of
/// all that has to be known of the simulation, so that it can be rendered while that continues. A plain
/// value.
struct ComingImage {
  /// The step that the image shows, which Simulation::cameraStep() will yield.
  std::uint64_t step = 0;
  /// The poses of all bodies after `step` and the steps before it, the oldest ones first.
  std::vector<std::vector<robotlink::Pose3>> past = {};

  /// The same poses as those that Simulation::cameraPoses() will yield.
  void poses(double age, std::vector<robotlink::Pose3>& poses) const;
};

}  // namespace simcore
