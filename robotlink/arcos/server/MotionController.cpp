// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/server/MotionController.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace robotlink::arcos {
namespace {

/// A position nearer than this is reached; standing wheels do not turn by less.
constexpr double kDistanceReached = 0.002;  // m
constexpr double kHeadingReached = 0.005;   // rad
/// The approach to a position is planned with this fraction of the deceleration, so that the profile can
/// follow the plan.
constexpr double kPlannedDeceleration = 0.9;

double finite(double value) {
  return std::isfinite(value) ? value : 0;
}

double limited(double value, double limit) {
  return std::clamp(finite(value), -limit, limit);
}

/// The new value of a parameter; 0 and values that are not finite keep the old one.
double parameter(double asked, double before, double top) {
  const double magnitude = std::abs(finite(asked));
  return magnitude > 0 ? std::min(magnitude, top) : before;
}

/// Returns the speed after a step of a trapezoidal profile from `speed` toward `target`.
double approached(double speed, double target, double acceleration, double deceleration, double passed) {
  const bool slower = speed != 0 && (speed * target <= 0 || std::abs(target) < std::abs(speed));
  const double change = (slower ? deceleration : acceleration) * passed;
  // The robot stops before it reverses.
  const double goal = slower && speed * target < 0 ? 0 : target;
  return speed < goal ? std::min(goal, speed + change) : std::max(goal, speed - change);
}

/// The highest speed from which the robot can still stop within the distance `rest`.
double speedTowards(double rest, double limit, double deceleration, double passed) {
  const double distance = std::abs(rest);
  const double braking = std::sqrt(2 * kPlannedDeceleration * deceleration * distance);
  return std::copysign(std::min({limit, braking, passed > 0 ? distance / passed : 0}), rest);
}

}  // namespace

MotionController::MotionController(MotionParameters flash) : flash_(flash), parameters_(flash) {}

void MotionController::setSpeed(double speed) {
  parameters_.speed = parameter(speed, parameters_.speed, parameters_.speedTop);
}

void MotionController::setRotation(double rate) {
  parameters_.rotation = parameter(rate, parameters_.rotation, parameters_.rotationTop);
}

void MotionController::setAcceleration(double acceleration) {
  parameters_.acceleration = parameter(acceleration, parameters_.acceleration, parameters_.accelerationTop);
}

void MotionController::setDeceleration(double deceleration) {
  parameters_.deceleration = parameter(deceleration, parameters_.deceleration, parameters_.accelerationTop);
}

void MotionController::setRotationAcceleration(double acceleration) {
  parameters_.rotationAcceleration =
      parameter(acceleration, parameters_.rotationAcceleration, parameters_.rotationAccelerationTop);
}

void MotionController::setRotationDeceleration(double deceleration) {
  parameters_.rotationDeceleration =
      parameter(deceleration, parameters_.rotationDeceleration, parameters_.rotationAccelerationTop);
}

void MotionController::restoreParameters() {
  parameters_ = flash_;
}

void MotionController::beginCommand() {
  if (!std::exchange(wheelsDriven_, false)) return;
  for (Channel* channel : {&translation_, &rotation_}) {
    channel->aim = Channel::Aim::kSpeed;
    channel->target = 0;
  }
}

void MotionController::translate(double speed) {
  if (!motorsOn_) return;
  beginCommand();
  translation_.aim = Channel::Aim::kSpeed;
  translation_.target = limited(speed, parameters_.speed);
}

void MotionController::move(double distance) {
  if (!motorsOn_) return;
  beginCommand();
  translation_.aim = Channel::Aim::kPosition;
  translation_.target = traveled_ + finite(distance);
  translation_.limit = parameters_.speed;
}

void MotionController::rotate(double rate) {
  if (!motorsOn_) return;
  beginCommand();
  rotation_.aim = Channel::Aim::kSpeed;
  rotation_.target = limited(rate, parameters_.rotation);
}

void MotionController::turnTo(double heading) {
  if (!motorsOn_) return;
  beginCommand();
  rotation_.aim = Channel::Aim::kPosition;
  rotation_.target = normalizedAngle(finite(heading));
  rotation_.limit = parameters_.rotation;
}

void MotionController::turnBy(double angle) {
  turnTo(odometry_.heading + finite(angle));
}

void MotionController::turnFromSetpoint(double angle) {
  turnTo(headingSetpoint() + finite(angle));
}

void MotionController::driveWheels(double left, double right) {
  if (!motorsOn_) return;
  const double l = finite(left), r = finite(right);
  translation_.aim = rotation_.aim = Channel::Aim::kSpeed;
  translation_.target = limited((l + r) / 2, parameters_.speed);
  rotation_.target = limited((r - l) / parameters_.track, parameters_.rotation);
  wheelsDriven_ = true;
}

void MotionController::stop() {
  wheelsDriven_ = false;
  for (Channel* channel : {&translation_, &rotation_}) {
    channel->aim = Channel::Aim::kSpeed;
    channel->target = 0;
  }
}

void MotionController::emergencyStop() {
  stop();
  translation_.speed = rotation_.speed = 0;
}

void MotionController::enable(bool motors) {
  if (motors == motorsOn_) return;
  motorsOn_ = motors;
  emergencyStop();
  stallLeft_ = {};
  leftStalled_ = rightStalled_ = false;
}

void MotionController::reset() {
  emergencyStop();
  odometry_ = {};
  traveled_ = 0;
  last_.reset();
  stallLeft_ = {};
  leftStalled_ = rightStalled_ = false;
}

void MotionController::setOdometry(const Pose2& pose) {
  const double turned = finite(pose.heading) - odometry_.heading;
  odometry_ = {finite(pose.x), finite(pose.y), normalizedAngle(finite(pose.heading))};
  if (rotation_.aim == Channel::Aim::kPosition) rotation_.target = normalizedAngle(rotation_.target + turned);
}

double MotionController::headingSetpoint() const {
  return rotation_.aim == Channel::Aim::kPosition ? rotation_.target : odometry_.heading;
}

bool MotionController::moving() const {
  return motorsOn_ && (translation_.speed != 0 || rotation_.speed != 0);
}

void MotionController::stall(bool left, bool right) {
  if (!motorsOn_ || stallLeft_ > Duration{} || (!left && !right)) return;
  leftStalled_ = left;
  rightStalled_ = right;
  stallLeft_ = parameters_.stallPause;
  translation_.speed = rotation_.speed = 0;
}

void MotionController::updateOdometry(const Wheels& wheels, Duration passed) {
  const Wheels before = last_.value_or(wheels);
  last_ = wheels;
  const double left = finite(wheels.leftTravel - before.leftTravel);
  const double right = finite(wheels.rightTravel - before.rightTravel);
  const double forwards = (left + right) / 2;
  const double turned = wheels.rotationRate ? finite(*wheels.rotationRate) * seconds(passed)
                                            : (right - left) / parameters_.track;
  // Half of the turn before and half of it after the translation: exact to the second order.
  const double heading = odometry_.heading + turned / 2;
  odometry_.x += forwards * std::cos(heading);
  odometry_.y += forwards * std::sin(heading);
  odometry_.heading = normalizedAngle(odometry_.heading + turned);
  traveled_ += forwards;
}

void MotionController::checkStall(const Wheels& wheels, Duration passed) {
  if (stallLeft_ > Duration{}) {
    stallLeft_ -= passed;
    return;
  }
  leftStalled_ = rightStalled_ = false;
  stall(wheels.leftBlocked, wheels.rightBlocked);
}

double MotionController::translationWanted(double passed) {
  if (held_) return 0;
  if (translation_.aim == Channel::Aim::kSpeed) return translation_.target;
  const double rest = translation_.target - traveled_;
  if (std::abs(rest) > kDistanceReached) {
    return speedTowards(rest, translation_.limit, parameters_.deceleration, passed);
  }
  // The goal is reached; if the robot is pushed away now, it does not return.
  translation_ = {Channel::Aim::kSpeed, 0, 0, translation_.speed};
  return 0;
}

double MotionController::rotationWanted(double passed) {
  if (held_) return 0;
  if (rotation_.aim == Channel::Aim::kSpeed) return rotation_.target;
  const double rest = normalizedAngle(rotation_.target - odometry_.heading);
  if (std::abs(rest) <= kHeadingReached) return 0;
  return speedTowards(rest, rotation_.limit, parameters_.rotationDeceleration, passed);
}

WheelCommand MotionController::step(const Wheels& wheels, Duration passed) {
  updateOdometry(wheels, passed);
  if (!motorsOn_) return {};
  checkStall(wheels, passed);
  if (stallLeft_ > Duration{}) return {};
  const double dt = seconds(passed);
  const MotionParameters& p = parameters_;
  translation_.speed =
      approached(translation_.speed, translationWanted(dt), p.acceleration, p.deceleration, dt);
  rotation_.speed =
      approached(rotation_.speed, rotationWanted(dt), p.rotationAcceleration, p.rotationDeceleration, dt);
  const double outwards = rotation_.speed * p.track / 2;
  return {translation_.speed - outwards, translation_.speed + outwards, true};
}

}  // namespace robotlink::arcos
