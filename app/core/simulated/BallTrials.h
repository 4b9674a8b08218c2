// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "app/core/simulated/SimulatedRun.h"

namespace app {

/// The same game from many starts: the ball anywhere within a radius of the first robot, on the field and
/// clear of the robot, by seed. Tells whether and when the robot touched it.
struct BallTrials {
  struct Trial {
    std::uint64_t seed = 0;
    robotlink::Vector2 ball;  ///< m, in the field
    bool touched = false;
    double touchedAfter = 0;  ///< s, simulated
    double moved = 0;         ///< m, how far the ball got
    bool fell = false;        ///< the robot lay at the end
  };
  RunOptions run;
  std::uint64_t firstSeed = 1;
  int count = 20;
  double radius = 1.5;                        ///< m
  double seconds = 60;                        ///< a trial's limit, simulated
  double afterTouch = 2;                      ///< s, simulated, to see where the ball goes
  std::function<void(const Trial&)> onTrial;  ///< progress
  std::function<bool()>
      stop;  ///< asked often; true: the trial that is played and those behind it are left out

  tl::expected<std::vector<Trial>, robotlink::Errors> play() const;
};

}  // namespace app
