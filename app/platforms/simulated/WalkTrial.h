// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/platforms/simulated/SimulatedRun.h"

namespace app {

/// A measurement of how the first robot of a scene walks when it is steered: it is placed before the middle
/// of the field with a heading that the seed chooses, waits for a moment, walks until its speed is steady,
/// and is measured then. The seed varies the commanded velocity, too, so that no gait is good for one course
/// only. Its layout needs a solution of the task behavior that obeys (`RunOptions::solutions`).
/// Deterministic.
struct WalkTrial {
  /// The mean velocity in the robot's frame, m/s to the front and to the left, rad/s counterclockwise.
  struct Velocity {
    double forward = 0, sideward = 0, rotation = 0;
  };
  struct Result {
    /// The commanded and the actual velocity; a robot that fell counts as one that did not move.
    Velocity asked, walked;
    /// The least z-component of the body's z-axis (1 is upright).
    double leastUpright = 1;
    bool fell = false;
  };

  /// The simulation; it has neither referee nor kick-offs. Its seed is that of the trial.
  RunOptions run;
  SimulatedRun::Listeners listeners = {};
  /// The commanded velocity; the gait limits it.
  Velocity asked;
  /// The duration of the measurement, simulated s.
  double seconds = 5;

  /// Fails if the simulation cannot be run or has no robot, or if the robot cannot be placed or steered.
  tl::expected<Result, robotlink::Errors> measure() const;
};

}  // namespace app
