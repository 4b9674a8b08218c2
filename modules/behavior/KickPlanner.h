// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "modules/behavior/BallSkills.h"
#include "modules/behavior/TeamPlaces.h"
#include "robotlink/base/Geometry.h"

namespace modules {

/// Chooses the direction in which a player plays the ball, and the kick ahead, far ahead, or to a side: those
/// after which the ball is soonest in the opponent's goal, by an estimate of the time for walking to the
/// ball, and for what is left of the way after a kick that rolls along walls and stops at robots. All in the
/// team's frame, meters, seconds and rad.
///
/// It keeps its last choice as long as no other one is clearly better. Not thread-safe.
class KickPlanner {
 public:
  struct Options {
    /// The distance that a kick ahead and one to a side move the ball, m.
    double kickLength = 0.7, sideLength = 0.9;
    /// The standard deviation of their directions, rad.
    double kickSpread = 0.2, sideSpread = 0.25;
    /// The same of the far kick ahead, which takes its time: it is played only if no opponent is this near to
    /// the ball, m. 0: never.
    double farLength = 1.5, farSpread = 0.15, farClearance = 0;
    /// The cost of the far kick, which takes longer and misses more often, s.
    double farSeconds = 2;
    /// Estimated time for each kick, s, and for each meter that the ball is still away from the goal.
    double secondsPerKick = 4, secondsPerMeter = 9;
    /// The cost of a ball next to a wall, from where it is hard to play, s.
    double wallSeconds = 8;
    /// The time by which another direction has to be sooner to be chosen instead of the last one, s.
    double keepSeconds = 1.5;
    /// The cost of a robot that stops the ball, s.
    double stoppedSeconds = 0;
    /// The cost of an opponent that stands where the robot has to be behind the ball, s.
    double occupiedSeconds = 3;
    /// How many times as much the time until a kick counts while an opponent is this near to the ball, m, and
    /// may play it first.
    double haste = 1, hasteDistance = 0.45;
    bool operator==(const Options&) const = default;
  };
  struct Choice {
    KickKind kind = KickKind::kAhead;
    /// The direction of the ball, in the field, rad.
    double direction = 0;
    /// The heading of the robot when it kicks, rad.
    double heading() const { return direction - angleOf(kind); }
  };
  /// The situation in which a kick begins, and the obstacles in its way.
  struct Situation {
    robotlink::Pose2 robot;
    robotlink::Vector2 ball;
    std::vector<robotlink::Vector2> opponents;
    /// Robots of the own team, which stop a ball, too.
    std::vector<robotlink::Vector2> mates = {};
    /// How fast the player walks, and how far from the ball.
    BallSkills skills{{}};
  };

  /// `places` must outlive it.
  KickPlanner(const TeamPlaces& places, const Options& options) : places_(places), options_(options) {}
  void setOptions(const Options& options) { options_ = options; }

  /// `keeps` stays with the last choice if there is one, as is best while the ball is at the paws.
  Choice choose(const Situation& now, bool keeps = false);
  /// Estimated time until the ball is in the goal with such a kick; nothing if there is no room behind the
  /// ball for it.
  std::optional<double> secondsToGoal(const Situation& now, const Choice& choice) const;

 private:
  /// Whether there is time for such a kick.
  bool hasTime(const Situation& now, KickKind kind) const;
  double lengthOf(KickKind kind) const;
  double spreadOf(KickKind kind) const;
  double secondsBehind(const Situation& now, double heading) const;
  double secondsAfter(const Situation& now, const Choice& choice) const;
  static bool isStopped(const Situation& now, const robotlink::Vector2& from, const robotlink::Vector2& to);

  const TeamPlaces& places_;
  Options options_;
  /// The last choice: a kick, and the number of a direction of the circle, or that of the goal.
  std::optional<std::pair<KickKind, int>> last_;
};

}  // namespace modules
