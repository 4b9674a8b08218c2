// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "modules/driving/Outline.h"

namespace modules {

/// Follows a path by pure pursuit (Coulter 1992): steers along the arc to a point of it that is some way
/// ahead; slower in curves and before the end, turning on the spot where the path is behind or the goal wants
/// a heading.
class PathFollower {
 public:
  struct Options {
    double speed = 0.5, rotation = 0.8;  ///< m/s, rad/s
    double slowest = 0.06;               ///< m/s, near the goal
    double lookAhead = 0.7;              ///< m, along the path
    double braking = 0.2;                ///< m/s^2, before the goal
    double near = 0.1;                   ///< m, from the goal that is near enough
    double away = 0.3;                   ///< m, from it that begins everything anew
    double headingNear = 0.06;           ///< rad
    double turnOnSpot = 0.9;             ///< rad, from the way from which on it turns on the spot first
  };
  enum class State { kNoPath, kDriving, kTurning, kThere };
  explicit PathFollower(const Options& options) : options_(options) {}
  void setOptions(const Options& options) { options_ = options; }

  /// `points`: of the path, in the same frame as the robot; `heading`: at its end, if one is wanted.
  DriveVelocity decide(const robotlink::Pose2& robot, std::span<const robotlink::Vector2> points,
                       std::optional<double> heading);
  State state() const { return state_; }
  /// The point that it steers for.
  const robotlink::Vector2& target() const { return target_; }

 private:
  robotlink::Vector2 pointAhead(const robotlink::Vector2& place,
                                std::span<const robotlink::Vector2> points) const;
  DriveVelocity atTheEnd(const robotlink::Pose2& robot, std::optional<double> heading);
  DriveVelocity pursue(const robotlink::Pose2& robot, double left);

  Options options_;
  State state_ = State::kNoPath;
  robotlink::Vector2 goal_ = robotlink::Vector2::Zero();
  robotlink::Vector2 target_ = robotlink::Vector2::Zero();
  bool arrived_ = false;
  bool spinning_ = false;
};

}  // namespace modules
