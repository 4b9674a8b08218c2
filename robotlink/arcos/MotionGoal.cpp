// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/MotionGoal.h"

#include <cmath>

namespace robotlink::arcos {
namespace {

constexpr double kArrivedSpeed = 0.005;             // m/s
constexpr double kStandingRotation = radians(1.0);  // rad/s
/// In m; a longer step means that the odometry was reset.
constexpr double kLongestStep = 1.0;

bool stands(const RobotState& state) {
  return !state.moving && std::abs(state.speed) < kArrivedSpeed &&
         std::abs(state.rotation) < kStandingRotation;
}

}  // namespace

MotionGoal MotionGoal::move(const RobotState& state, Instant now, double distance) {
  MotionGoal goal(state, now);
  goal.distance_ = distance;
  return goal;
}

MotionGoal MotionGoal::turn(const RobotState& state, Instant now, double heading) {
  MotionGoal goal(state, now);
  goal.heading_ = heading;
  return goal;
}

bool MotionGoal::isReached(const RobotState& state) const {
  if (distance_ && std::abs(traveled_ - *distance_) > kTolerance) return false;
  return !heading_ || std::abs(normalizedAngle(state.pose.heading - *heading_)) <= kTurnTolerance;
}

std::optional<MotionEnd> MotionGoal::take(const RobotState& state) {
  const Pose2 step = last_.inverse() * state.pose;
  last_ = state.pose;
  if (step.translation().norm() <= kLongestStep) traveled_ += step.x;
  // A state from before the command does not show its effect.
  if (state.time < commanded_) return std::nullopt;
  if (state.stalled()) return MotionEnd::kStalled;
  if (!stands(state) || state.time < commanded_ + kStart) return std::nullopt;
  return isReached(state) ? MotionEnd::kArrived : MotionEnd::kStopped;
}

}  // namespace robotlink::arcos
