// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "app/platforms/simulated/SimulatedRun.h"

namespace app {

/// Repeated trials of whether a robot finds the ball: each one resets the simulation with its own seed and
/// places the ball at random within a radius of the first robot, on the field and clear of the robot. The
/// result says whether and when the ball was touched. Deterministic for given options, unless a module does
/// not return within the patience of the run: then its robot stands still for the rest of that trial.
struct BallTrials {
  /// A trial and its result.
  struct Trial {
    std::uint64_t seed = 0;
    /// The initial position of the ball, in the field's frame, m.
    robotlink::Vector2 ball;
    bool touched = false;
    /// Simulated time from the start to the first touch, s; 0 without one.
    double touchedAfter = 0;
    /// Distance from the ball's start to its end, m.
    double moved = 0;
    /// Whether the robot was no longer upright at the end.
    bool fell = false;
    /// Whether the ball entered a goal, which is checked only with `goals`: that of the opponents of the
    /// first robot's team; and when, simulated s.
    bool scored = false;
    double scoredAfter = 0;
    /// The initial pose of the robot, in the field's frame.
    robotlink::Pose2 robot;
  };
  /// The simulation. Kick-offs are switched off.
  RunOptions run;
  /// Called with the events of the simulation; what they refer to must exist until modules have returned.
  SimulatedRun::Listeners listeners = {};
  /// The seed of the first trial; each further one has the next number.
  std::uint64_t firstSeed = 1;
  /// The number of trials to play.
  int count = 20;
  /// The largest distance of the ball from the robot, m.
  double radius = 1.5;
  /// The end of a trial without a touch, simulated s.
  double seconds = 60;
  /// Robot and ball are placed anywhere on the field, whatever the radius is, and a trial ends with a goal
  /// instead of a touch.
  bool goals = false;
  /// The time for which a trial continues after the first touch, simulated s.
  double afterTouch = 2;
  /// Called after each trial; may be empty.
  std::function<void(const Trial&)> onTrial;
  /// Called before each step; true cancels the current trial and those that remain. May be empty.
  std::function<bool()> stop;

  /// Plays the trials and returns those that were finished. Fails if the simulation cannot be run, has no
  /// robot, no ball, or no place for the ball.
  tl::expected<std::vector<Trial>, robotlink::Errors> play() const;
};

}  // namespace app
