// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "modules/behavior/GameSituation.h"
#include "robotlink/base/Geometry.h"

namespace robotlink {
struct FieldDescription;
}

namespace modules {

/// Computes the positions and targets of a team's players, in the team's frame (the own goal at -x, see
/// GameSituation), computed from the field's measures. Meters. Immutable.
class TeamPlaces {
 public:
  struct Options {
    /// Distance of the goalie from its goal line.
    double goalieDistance = 0.2;
    /// The distance of the defender from the ball toward its own goal.
    double defenderDistance = 0.9;
    /// The supporter stands this far behind the ball (negative: ahead of it), and this far to its side; ahead
    /// of
    /// it in any case while the ball is near the own goal.
    double supporterBack = 0.5, supporterAside = 0.7;
    /// How far players that wait for a ball before the opponents' goal stand from its line, and those before
    /// their own penalty area from that.
    double beforeGoal = 0.9;
    /// The least distance of these places from walls.
    double wallDistance = 0.25;
  };

  TeamPlaces(const robotlink::FieldDescription& field, const Options& options);

  /// The middle of the goal line.
  robotlink::Vector2 ownGoal() const { return {-goalX_, 0}; }
  robotlink::Vector2 opponentGoal() const { return {goalX_, 0}; }
  double goalWidth() const { return goalWidth_; }

  /// The pose of a player at the kick-off, looking at the opponent's goal. The goalie of several players has
  /// the place nearest to its goal.
  robotlink::Pose2 kickOff(int number, bool isGoalie) const;
  /// The place between ball and goal, near the goal line.
  robotlink::Pose2 goalie(const robotlink::Vector2& ball) const;
  /// The place between ball and goal, outside of the penalty area.
  robotlink::Pose2 defender(const robotlink::Vector2& ball) const;
  /// Next to and behind the ball, on the side of the field that is wider; next to and before it near the own
  /// goal, and before the opponents' goal while the ball is in a corner there.
  robotlink::Pose2 supporter(const robotlink::Vector2& ball) const;
  /// The place before the own penalty area, far enough from it for cleared balls to arrive.
  robotlink::Pose2 beforeArea(const robotlink::Vector2& ball) const;

  /// The point of the opponent's goal to which a ball is played: the middle of the widest gap between robots
  /// (in the team's frame) that stand between it and the goal. From the side of the goal, its far half is
  /// meant.
  robotlink::Vector2 aim(const robotlink::Vector2& ball, const std::vector<robotlink::Vector2>& robots) const;

  /// Whether a goalie may go for a ball here: the penalty area and a margin around it.
  bool isGoaliesBall(const robotlink::Vector2& ball, double margin) const;
  /// Whether a robot is beyond its field, such as in a goal.
  bool isOutside(const robotlink::Vector2& place) const;
  /// The nearest place that is no closer to the walls than allowed.
  robotlink::Vector2 inside(const robotlink::Vector2& place) const;
  /// The nearest place at which a robot fits next to the walls and the ramps in the corners.
  robotlink::Vector2 reachable(const robotlink::Vector2& place) const;
  /// The nearest place whose distance from walls and ramps is not less than `distance`.
  robotlink::Vector2 within(const robotlink::Vector2& place, double distance) const;

 private:
  robotlink::Pose2 facing(const robotlink::Vector2& place, const robotlink::Vector2& ball) const;

  Options options_;
  double goalX_, touchY_, goalWidth_, penaltyLength_, penaltyWidth_, cornerSide_;
  /// The places at the kick-off, the ones next to the opponents first.
  std::vector<robotlink::Pose2> kickOff_;
};

}  // namespace modules
