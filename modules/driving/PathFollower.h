// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "modules/driving/Outline.h"

namespace modules {

/// Follows a path by pure pursuit (Coulter 1992): steers along an arc to a point of the path that is some
/// distance ahead. It is slower in curves and near the end, and turns on the spot where the path is behind
/// the robot or the goal has a heading. Not thread-safe.
class PathFollower {
 public:
  struct Options {
    /// Maximal speeds, m/s and rad/s.
    double speed = 0.5, rotation = 0.8;
    /// Minimal speed near the goal, m/s.
    double slowest = 0.06;
    /// Distance of the steering point along the path, m.
    double lookAhead = 0.7;
    /// Deceleration before the goal, m/s^2.
    double braking = 0.2;
    /// Distance from the goal at which it is reached, m.
    double near = 0.1;
    /// Distance from the goal at which a robot that has arrived drives again, m.
    double away = 0.3;
    /// Tolerance of the heading at the goal, rad.
    double headingNear = 0.06;
    /// Angle to the path above which it first turns on the spot, rad.
    double turnOnSpot = 0.9;
  };
  /// The current activity; kThere means that the goal, and its heading if any, is reached.
  enum class State { kNoPath, kDriving, kTurning, kThere };
  explicit PathFollower(const Options& options) : options_(options) {}
  void setOptions(const Options& options) { options_ = options; }

  /// `points` are those of the path in the frame of the robot's pose; `heading` is that at its end, if it
  /// matters.
  DriveVelocity decide(const robotlink::Pose2& robot, std::span<const robotlink::Vector2> points,
                       std::optional<double> heading);
  State state() const { return state_; }
  /// The point that it steers to.
  const robotlink::Vector2& target() const { return target_; }

 private:
  /// The steering point: on the path, lookAhead beyond the point nearest to `place`.
  robotlink::Vector2 pointAhead(const robotlink::Vector2& place,
                                std::span<const robotlink::Vector2> points) const;
  /// The rotation on the spot for a remaining angle, not slower than `slowest` unless the robot may not turn
  /// that fast, rad/s.
  double spin(double turn, double slowest) const;
  /// Turns to the goal's heading.
  DriveVelocity atTheEnd(const robotlink::Pose2& robot, std::optional<double> heading);
  /// Drives along an arc to the steering point; `left` is the remaining length, m.
  DriveVelocity pursue(const robotlink::Pose2& robot, double left);

  Options options_;
  State state_ = State::kNoPath;
  robotlink::Vector2 goal_ = robotlink::Vector2::Zero();
  robotlink::Vector2 target_ = robotlink::Vector2::Zero();
  /// The goal was reached and the robot has not left it since.
  bool arrived_ = false;
  /// The robot is turning in place toward the path.
  bool spinning_ = false;
};

}  // namespace modules
