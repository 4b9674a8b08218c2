// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/behavior/BallSkills.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace modules {

using robotlink::normalizedAngle;
using robotlink::Vector2;

namespace {

/// How far a way is turned at most to pass robots, how much farther on their right than on their left, and
/// how much farther on the side on which it passes them already, rad.
constexpr double kMaxDetour = 2.2, kPassRight = 0.1, kKeepSide = 0.4;

/// The distance of a ball ahead of its kicking position when the paws reach it, m.
constexpr double kAtPaws = 0.06;

/// The share of a turn that is not made on the way.
constexpr double kTurnShare = 0.4;

double headingOf(const Vector2& way) {
  return std::atan2(way.y(), way.x());
}

Vector2 inDirection(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

}  // namespace

double angleOf(KickKind kind) {
  if (kind == KickKind::kLeft) return robotlink::kPi / 2;
  return kind == KickKind::kRight ? -robotlink::kPi / 2 : 0;
}

Intention BallSkills::walk(const Vector2& velocity, double turn) const {
  Intention intention;
  intention.motion = Intention::Motion::kWalk;
  intention.turn = std::clamp(turn, -options_.turnSpeed, options_.turnSpeed);
  const double ahead = velocity.x() < 0 ? options_.backwardSpeed : options_.forwardSpeed;
  // The speeds share the legs' reach, as the gait has it; translation yields to rotation.
  const double share =
      std::sqrt(std::max(0.04, 1 - std::pow(intention.turn / (1.35 * options_.turnSpeed), 2)));
  const double excess =
      std::max(1.0, std::hypot(velocity.x() / ahead, velocity.y() / options_.sidewardSpeed) / share);
  intention.forward = velocity.x() / excess;
  intention.left = velocity.y() / excess;
  intention.head = Intention::Head::kTrack;
  return intention;
}

std::vector<BallSkills::Circle> BallSkills::circles(const std::vector<Vector2>& robots, double radius) {
  std::vector<Circle> all;
  for (const Vector2& robot : robots) all.push_back({robot, radius});
  return all;
}

Intention BallSkills::turnTo(double direction) const {
  return walk(Vector2::Zero(), options_.turnGain * normalizedAngle(direction));
}

Vector2 BallSkills::around(const Vector2& way, const std::vector<Circle>& circles, double maxDetour) {
  const double distance = way.norm();
  const double last = std::exchange(detour_, 0);
  if (distance < 0.05) return way;
  // The turns of the way that hit a circle: their middle, and half their range.
  std::vector<std::pair<double, double>> blocked;
  const double direction = headingOf(way);
  for (const Circle& circle : circles) {
    const double apart = circle.middle.norm();
    // Beyond the aim, or the own body: not in the way.
    if (apart > options_.robotRange || apart > distance + 0.1 || apart < 0.05) continue;
    blocked.emplace_back(normalizedAngle(headingOf(circle.middle) - direction),
                         std::asin(std::min(1.0, circle.radius / apart)));
  }
  const auto isFree = [&](double turn) {
    return std::ranges::none_of(blocked, [&](const auto& one) {
      return std::abs(normalizedAngle(turn - one.first)) < one.second - 1e-6;
    });
  };
  if (isFree(0)) return way;
  // Robots that stand side by side are passed together. One that is met head-on is passed on the right, by
  // both.
  double best = 0, least = std::numeric_limits<double>::infinity();
  for (const auto& [middle, half] : blocked) {
    for (const double edge : {middle - half, middle + half}) {
      const double turn = normalizedAngle(edge);
      const double cost = std::abs(turn) + (turn > 0 ? kPassRight : 0) - (turn * last > 0 ? kKeepSide : 0);
      if (cost >= least || std::abs(turn) >= maxDetour || !isFree(turn)) continue;
      least = cost;
      best = turn;
    }
  }
  detour_ = best;
  return Eigen::Rotation2Dd(best) * way;
}

Intention BallSkills::walkTo(const Vector2& place, double direction, const std::vector<Vector2>& robots) {
  const double distance = place.norm();
  const Vector2 way = around(place, circles(robots, options_.robotRadius), kMaxDetour);
  if (distance < options_.nearby) {
    const Vector2 velocity = options_.walkGain * way;
    return walk(velocity, options_.turnGain * normalizedAngle(direction));
  }
  const double heading = headingOf(way);
  // A trot does not turn and walk well at the same time: the wider the turn, the slower the walk.
  const double share = std::clamp(1.5 - std::abs(heading) / 0.6, 0.0, 1.0);
  // Begins to turn to the last direction before it arrives.
  const double blend = std::clamp((distance - options_.nearby) / 0.3, 0.0, 1.0);
  const double facing = normalizedAngle(heading + (1 - blend) * 0.5 * normalizedAngle(direction - heading));
  return walk(way.normalized() * options_.forwardSpeed * share, options_.turnGain * facing);
}

Intention BallSkills::makeWay(const Vector2& place, const Vector2& ball, const std::vector<Vector2>& robots) {
  std::vector<Circle> obstacles = circles(robots, options_.duelRadius);
  obstacles.push_back({ball, options_.clearDistance});
  const Vector2 way = around(place, obstacles, robotlink::kPi + kPassRight);
  return walk(way.normalized() * options_.forwardSpeed, 0);
}

double BallSkills::offset(const Vector2& ball, double aim) {
  return normalizedAngle(aim - headingOf(ball));
}

Vector2 BallSkills::placeBehind(const Vector2& ball, double aim) const {
  const Vector2 behind = ball - inDirection(aim) * options_.standOff;
  const Vector2 line = behind;  // from the robot, which is the origin
  const double length = line.norm();
  if (length < 1e-6) return behind;
  // The distance between the straight way there and the ball.
  const double along = std::clamp(ball.dot(line) / (length * length), 0.0, 1.0);
  if ((along * line - ball).norm() >= options_.passing - 0.01) return behind;
  // A tangent to the circle around the ball, on the side on which the place behind the ball is nearer.
  const double apart = ball.norm();
  const double side = offset(ball, aim) > 0 ? -1 : 1;
  if (apart <= options_.passing) {
    // Within the circle: along it, and out of it.
    const Vector2 out = -ball / std::max(0.01, apart);
    const Vector2 along90(-out.y() * -side, out.x() * -side);
    return 0.25 * along90 + out * (options_.passing - apart);
  }
  const double turn = std::asin(options_.passing / apart);
  const double reach = std::sqrt(apart * apart - options_.passing * options_.passing);
  return inDirection(headingOf(ball) + side * turn) * std::max(0.1, reach);
}

Intention BallSkills::approach(const Vector2& ball, double aim, const std::vector<Vector2>& robots) {
  const Vector2 place = placeBehind(ball, aim);
  // Near the ball it looks at it: it circles it with its head toward it.
  if (ball.norm() < 2 * options_.standOff + 0.1) {
    const Vector2 way = around(place, circles(robots, options_.duelRadius), kMaxDetour);
    const double facing = place.norm() < 0.12 ? 0.5 * (aim + headingOf(ball)) : headingOf(ball);
    return walk(options_.walkGain * std::max(1.0, 0.12 / std::max(0.02, way.norm())) * way,
                options_.turnGain * facing);
  }
  return walkTo(place, aim, robots);
}

Intention BallSkills::dribble(const Vector2& ball, double aim) const {
  // The ball is kept before the chest; turns are small, so that it is not lost.
  const double beside = ball.y();
  const double slow = std::clamp(1.6 - std::abs(beside) / options_.dribbleWidth, 0.25, 1.0);
  const double left = options_.dribbleGain * beside;
  return walk({options_.forwardSpeed * slow, left}, std::clamp(1.2 * aim, -0.6, 0.6) + 1.0 * beside);
}

BallSkills::KickSpot BallSkills::kickSpot(KickKind kind) const {
  const Options& o = options_;
  if (kind == KickKind::kAhead) return {{o.kickX, 0}, {o.kickToleranceX, o.kickToleranceY}};
  if (kind == KickKind::kFarAhead) return {{o.farX, 0}, {o.farToleranceX, o.farToleranceY}};
  return {{o.sideX, kind == KickKind::kLeft ? o.sideY : -o.sideY}, {o.sideToleranceX, o.sideToleranceY}};
}

Intention BallSkills::position(const Vector2& ball, const Vector2& ballVelocity, double aim,
                               KickKind kind) const {
  const Vector2 way = ball - kickSpot(kind).place;
  // A ball that rolls is followed.
  Vector2 velocity = options_.positionGain * way + ballVelocity;
  if (way.x() < kAtPaws) {
    // Slowly, and sideways first, so that no paw pushes the ball away.
    const double free = std::abs(way.y()) > 0.06 ? 0.3 : 1.0;
    velocity.x() = std::clamp(velocity.x() * free, -options_.positionSpeed, options_.positionSpeed);
  }
  return walk(velocity, options_.positionTurn * aim);
}

bool BallSkills::canKick(const Vector2& ball, KickKind kind) const {
  const KickSpot spot = kickSpot(kind);
  return ((ball - spot.place).array().abs() < spot.tolerance.array()).all();
}

/// Straight, or along a circle around the ball, and the rest of the turn there.
double BallSkills::secondsTo(const Vector2& ball, double aim) const {
  const double distance = std::max(ball.norm(), options_.standOff);
  const double beside = std::abs(offset(ball, aim));
  // From where the tangent of the circle touches it, the rest is along the circle.
  const double touch = std::acos(options_.standOff / distance);
  const double arc = std::max(0.0, beside - touch) * options_.standOff;
  const Vector2 behind = ball - inDirection(aim) * options_.standOff;
  const double straight =
      beside < touch ? behind.norm() : std::sqrt(distance * distance - options_.standOff * options_.standOff);
  const double turn = std::abs(normalizedAngle(aim));
  return straight / options_.forwardSpeed + arc / options_.sidewardSpeed +
         kTurnShare * turn / options_.turnSpeed;
}

}  // namespace modules
