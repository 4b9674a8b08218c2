// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "robotlink/arcos/RobotState.h"

namespace robotlink::arcos {

/// How a move() or a turn() ended.
enum class MotionEnd {
  kArrived,  ///< the robot stands where it was sent
  kStalled,  ///< its wheels are blocked: it has run into something
  kStopped,  ///< it stands elsewhere: it was stopped, its motors are off, or it did not hear the command
  kTimeout,  ///< it still moves after the time that was given
};

/// Where a move or a turn shall end, and whether the robot is there: robots drive so far by themselves, but
/// do not report that they have arrived. A plain value, fed with the robot's states.
class MotionGoal {
 public:
  /// By this much a robot that stands may have missed its goal; more, and something else has stopped it.
  static constexpr double kTolerance = 0.05;  // m
  static constexpr double kTurnTolerance = radians(5.0);
  /// So long after the command a robot may still stand because it has not begun yet.
  static constexpr Duration kStart = std::chrono::milliseconds(700);

  /// Commanded now, when the robot's state was `state`. `distance`: m, forwards.
  static MotionGoal move(const RobotState& state, Instant now, double distance);
  /// `heading`: in the frame of the odometry.
  static MotionGoal turn(const RobotState& state, Instant now, double heading);

  /// The robot's next state. None as long as it is on its way.
  std::optional<MotionEnd> take(const RobotState& state);

 private:
  MotionGoal(const RobotState& state, Instant now) : commanded_(now), last_(state.pose) {}
  bool isReached(const RobotState& state) const;

  Instant commanded_;
  Pose2 last_;
  double travelled_ = 0;  // m, forwards less backwards
  std::optional<double> distance_, heading_;
};

}  // namespace robotlink::arcos
