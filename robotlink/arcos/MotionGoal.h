// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "robotlink/arcos/RobotState.h"

namespace robotlink::arcos {

/// How a move() or a turn() of PioneerRobot ended.
enum class MotionEnd {
  /// The robot stands at its goal.
  kArrived,
  /// The wheels of the robot are blocked: it has hit something.
  kStalled,
  /// The robot stopped short of the goal: it was stopped, its motors are off, or it missed the command.
  kStopped,
  /// The robot was still moving when the time limit expired.
  kTimeout,
};

/// The goal of a move or a turn, and whether the robot has reached it: robots execute such commands by
/// themselves but do not report arrival. A plain value, fed with the robot's states.
class MotionGoal {
 public:
  /// Tolerance for a robot that stands near its goal, m; farther away, something else has stopped it.
  static constexpr double kTolerance = 0.05;  // m
  static constexpr double kTurnTolerance = radians(5.0);
  /// A robot that stands this soon after the command may not have started yet.
  static constexpr Duration kStart = std::chrono::milliseconds(700);

  /// Constructs the goal of a command sent at `now` in state `state`; `distance` in m, forwards.
  static MotionGoal move(const RobotState& state, Instant now, double distance);
  /// Constructs the goal of a turn; `heading` is in the odometry frame, rad.
  static MotionGoal turn(const RobotState& state, Instant now, double heading);

  /// Processes the next state; returns nothing while the robot is on its way. States older than the command
  /// do not end it.
  std::optional<MotionEnd> take(const RobotState& state);

 private:
  MotionGoal(const RobotState& state, Instant now) : commanded_(now), last_(state.pose) {}
  bool isReached(const RobotState& state) const;

  Instant commanded_;
  /// The last pose, for measuring traveled_.
  Pose2 last_;
  /// Distance traveled since the command, forwards minus backwards, m.
  double traveled_ = 0;
  /// The distance or the heading of the goal; one of the two is set.
  std::optional<double> distance_, heading_;
};

}  // namespace robotlink::arcos
