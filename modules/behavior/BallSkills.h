// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "modules/behavior/Intention.h"
#include "robotlink/base/Geometry.h"

namespace modules {

/// The kicks of a player: one straight ahead that is soon over, one that takes longer and reaches farther,
/// and those to the sides.
enum class KickKind { kAhead, kFarAhead, kLeft, kRight };
/// The direction in which it sends the ball, in the robot's frame, rad.
double angleOf(KickKind kind);

/// Walks a robot on legs to places and to the ball: controllers on plain values in the robot's frame (x
/// to the front, meters, radians), which remember only on which side they pass other robots.
///
/// Far away it turns to where it goes and walks ahead; near its aim it walks in any direction. Robots in the
/// way are passed on the nearer side: the direction of the walk is turned until it misses all of them, as in
/// the tangent bug (I. Kamon, E. Rivlin, E. Rimon, 1996), with circles for obstacles.
class BallSkills {
 public:
  struct Options {
    /// Meters per second.
    double forwardSpeed = 0.18, backwardSpeed = 0.12, sidewardSpeed = 0.12;
    /// Radians per second.
    double turnSpeed = 1.1;
    /// The gain of turning to an angle, 1/s.
    double turnGain = 2.0;
    /// The gain of walking to a near place, 1/s.
    double walkGain = 2.5;
    /// Distance up to which it walks in any direction, m.
    double nearby = 0.35;
    /// Radius of the circle around the middle of another robot that the own middle avoids, m.
    double robotRadius = 0.3;
    /// The same while it circles the ball, for which it has to get close to others that play it, m.
    double duelRadius = 0.17;
    /// Distance up to which robots are avoided, m.
    double robotRange = 0.7;
    /// Distance from the ball within which a player makes way for a mate that plays it, m.
    double clearDistance = 0.45;
    /// Distance of the place behind the ball, m.
    double standOff = 0.27;
    /// Distance at which it passes the ball on the way behind it, m.
    double passing = 0.26;
    /// The position of the ball for a kick, and its tolerance, m.
    double kickX = 0.16, kickToleranceX = 0.035, kickToleranceY = 0.04;
    /// The same of the far one.
    double farX = 0.12, farToleranceX = 0.015, farToleranceY = 0.04;
    /// The same of the kick to the left; that to the right is its mirror image.
    double sideX = 0.21, sideY = 0.03, sideToleranceX = 0.02, sideToleranceY = 0.025;
    /// The gain of walking there, 1/s, and the maximum speed with the ball before its paws, m/s.
    double positionGain = 1.8, positionSpeed = 0.08;
    /// The gain of turning to the goal there, 1/s.
    double positionTurn = 0.8;
    /// Sideward gain and limit of the error beside which it slows down while it pushes the ball, 1/s and m.
    double dribbleGain = 2.5, dribbleWidth = 0.05;
  };
  explicit BallSkills(const Options& options) : options_(options) {}
  void setOptions(const Options& options) { options_ = options; }
  const Options& options() const { return options_; }

  /// Walks to a place and looks in the end into a direction of the robot's frame.
  Intention walkTo(const robotlink::Vector2& place, double direction,
                   const std::vector<robotlink::Vector2>& robots);
  /// Only turns.
  Intention turnTo(double direction) const;
  /// The place from which the ball is walked to next: behind it as seen in the direction `aim` (an angle), or
  /// next to it on the way there.
  robotlink::Vector2 placeBehind(const robotlink::Vector2& ball, double aim) const;
  /// Walks to the place behind the ball.
  Intention approach(const robotlink::Vector2& ball, double aim,
                     const std::vector<robotlink::Vector2>& robots);
  /// Steps away from the ball for a mate that plays it, on the way to a place, without turning about.
  Intention makeWay(const robotlink::Vector2& place, const robotlink::Vector2& ball,
                    const std::vector<robotlink::Vector2>& robots);
  /// Pushes the ball into the direction `aim`, with the ball between the fore paws.
  Intention dribble(const robotlink::Vector2& ball, double aim) const;
  /// Walks to where a kick reaches a ball that rolls with this velocity (m/s), and turns to `aim`.
  Intention position(const robotlink::Vector2& ball, const robotlink::Vector2& ballVelocity, double aim,
                     KickKind kind) const;
  /// Whether a kick reaches the ball.
  bool canKick(const robotlink::Vector2& ball, KickKind kind) const;
  /// The error of the robot's place: the angle between the way to the ball and the aim; 0: straight behind.
  static double offset(const robotlink::Vector2& ball, double aim);
  /// The time that it takes to be behind the ball, s.
  double secondsTo(const robotlink::Vector2& ball, double aim) const;

 private:
  /// A walk within the limits of speed, whose direction is kept.
  Intention walk(const robotlink::Vector2& velocity, double turn) const;
  /// The position of the ball for a kick, and its tolerance.
  struct KickSpot {
    robotlink::Vector2 place, tolerance;
  };
  KickSpot kickSpot(KickKind kind) const;
  /// The circle that the robot's own center stays out of.
  struct Circle {
    robotlink::Vector2 middle;
    double radius;
  };
  static std::vector<Circle> circles(const std::vector<robotlink::Vector2>& robots, double radius);
  /// The way to a place, turned by as little as possible, and at most by `maxDetour` (rad), so that it passes
  /// the circles; unchanged if it cannot. In a circle it leads out of it.
  robotlink::Vector2 around(const robotlink::Vector2& way, const std::vector<Circle>& circles,
                            double maxDetour);

  Options options_;
  /// The turn of the last way, rad; 0 if it led straight there.
  double detour_ = 0;
};

}  // namespace modules
