// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/driving/PathFollower.h"

namespace modules {

using robotlink::normalizedAngle;
using robotlink::Pose2;
using robotlink::Vector2;

namespace {

/// The fraction of the way from `from` to `to` at which the line is nearest to a place.
double nearestShare(const Vector2& place, const Vector2& from, const Vector2& to) {
  const Vector2 way = to - from;
  const double squares = way.squaredNorm();
  return squares > 0 ? std::clamp((place - from).dot(way) / squares, 0.0, 1.0) : 0;
}

}  // namespace

Vector2 PathFollower::pointAhead(const Vector2& place, std::span<const Vector2> points) const {
  std::size_t nearest = 0;
  double least = 1e18, share = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double at = nearestShare(place, points[i], points[i + 1]);
    const double away = (points[i] + at * (points[i + 1] - points[i]) - place).norm();
    if (away >= least) continue;
    least = away;
    nearest = i;
    share = at;
  }
  double left = options_.lookAhead;
  for (std::size_t i = nearest; i + 1 < points.size(); ++i, share = 0) {
    const Vector2 way = points[i + 1] - points[i];
    const double length = way.norm() * (1 - share);
    if (length >= left) return points[i] + way * (share + left / way.norm());
    left -= length;
  }
  return points.back();
}

DriveVelocity PathFollower::decide(const Pose2& robot, std::span<const Vector2> points,
                                   std::optional<double> heading) {
  if (points.empty()) {
    state_ = State::kNoPath;
    arrived_ = false;
    return {};
  }
  const double left = (points.back() - robot.translation()).norm();
  if ((points.back() - goal_).norm() > options_.near || left > options_.away) arrived_ = false;
  goal_ = points.back();
  arrived_ = arrived_ || left < options_.near;
  if (arrived_) return atTheEnd(robot, heading);
  state_ = State::kDriving;
  target_ = pointAhead(robot.translation(), points);
  return pursue(robot, left);
}

double PathFollower::spin(double turn, double slowest) const {
  return std::copysign(std::min(std::max(1.5 * std::abs(turn), slowest), options_.rotation), turn);
}

DriveVelocity PathFollower::atTheEnd(const Pose2& robot, std::optional<double> heading) {
  target_ = goal_;
  const double turn = heading ? normalizedAngle(*heading - robot.heading) : 0;
  // Having reached the heading, it stays there until it is clearly turned away.
  const double near = state_ == State::kThere ? 2 * options_.headingNear : options_.headingNear;
  state_ = std::abs(turn) < near ? State::kThere : State::kTurning;
  if (state_ == State::kThere) return {};
  return {0, spin(turn, 0.1)};
}

DriveVelocity PathFollower::pursue(const Pose2& robot, double left) {
  const Vector2 ahead = robot.inverse() * target_;
  const double turn = std::atan2(ahead.y(), ahead.x());
  spinning_ = std::abs(turn) > (spinning_ ? 0.3 * options_.turnOnSpot : options_.turnOnSpot);
  if (spinning_) return {0, spin(turn, 0.2)};
  const double curvature = 2 * ahead.y() / std::max(1e-6, ahead.squaredNorm());
  double speed = std::min(options_.speed, std::sqrt(2 * options_.braking * left));
  if (std::abs(curvature) * speed > options_.rotation) speed = options_.rotation / std::abs(curvature);
  speed = std::max(std::min(options_.slowest, options_.speed), speed * std::cos(turn));
  return {speed, std::clamp(curvature * speed, -options_.rotation, options_.rotation)};
}

}  // namespace modules
