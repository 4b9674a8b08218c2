// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "modules/behavior/GameSituation.h"
#include "modules/behavior/Intention.h"

namespace robotlink {
struct FieldDescription;
}

namespace modules {

/// A reactive player without states and roles: it walks along the sum of forces that ball, walls and robots
/// exert on it, and kicks whenever the ball is before its chest and the goal ahead.
///
/// The ball attracts; on its wrong side a vortex around it leads to the side from which the goal is ahead.
/// Walls and robots repel. After O. Khatib, "Real-time obstacle avoidance for manipulators and mobile robots"
/// (1986), and T. Laue and T. Röfer, "A behavior architecture for autonomous mobile robots based on potential
/// fields" (RoboCup 2004). Deterministic: what it does depends on the situation only. Meters, seconds.
class PotentialField {
 public:
  struct Options {
    /// Meters per second, and radians per second.
    double forwardSpeed = 0.15, sidewardSpeed = 0.10, turnSpeed = 0.9;
    /// The gain of turning to the direction of motion, 1/s.
    double turnGain = 1.6;
    /// Speed toward a far ball, m/s, and distance within which it becomes smaller, m.
    double attraction = 0.2, slowing = 0.3;
    /// Speed along the circle around the ball on its wrong side, m/s, and the radius of that circle, m.
    double swirl = 0.15, swirlRadius = 0.4;
    /// Speed away from a robot that is touched, m/s, and distance at which it is 0, m.
    double repulsion = 0.3, repulsionRadius = 0.5;
    /// The same of walls.
    double wallRepulsion = 0.15, wallRadius = 0.2;
    /// The position of the ball for a kick, m, and the angle up to which the goal is ahead, rad.
    double kickX = 0.155, kickToleranceX = 0.03, kickToleranceY = 0.035, kickAngle = 0.5;
    /// Rotation while it does not know the ball, rad/s.
    double turnAbout = 0.7;
    std::string kick = "kick-forward";
  };

  explicit PotentialField(const robotlink::FieldDescription& field);
  void setOptions(const Options& options) { options_ = options; }

  /// Call it once a frame.
  Intention decide(const GameSituation& now);
  /// The current action, in words, and the reason.
  const char* state() const { return state_; }
  const char* reason() const { return reason_; }

  /// The force at a place while the ball and everything else stay where they are, m/s; all in the robot's
  /// frame. For decisions and drawings.
  robotlink::Vector2 force(const GameSituation& now, const robotlink::Vector2& place) const;
  robotlink::Vector2 ballForce(const GameSituation& now, const robotlink::Vector2& place) const;
  robotlink::Vector2 robotForce(const GameSituation& now, const robotlink::Vector2& place) const;
  robotlink::Vector2 wallForce(const GameSituation& now, const robotlink::Vector2& place) const;
  /// The position of the opponent's goal, in the robot's frame; empty if the robot does not know it.
  std::optional<robotlink::Vector2> goal(const GameSituation& now) const;

 private:
  Intention stand(const char* state, const char* reason);
  Intention play(const GameSituation& now);
  Intention walk(const robotlink::Vector2& velocity, double direction) const;
  bool canKick(const GameSituation& now) const;

  Options options_;
  double goalX_, touchY_;
  const char* state_ = "stand";
  const char* reason_ = "";
};

}  // namespace modules
