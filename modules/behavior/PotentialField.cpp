// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/behavior/PotentialField.h"

#include <algorithm>
#include <cmath>

#include "robotlink/config/FieldDescription.h"

namespace modules {

using robotlink::normalizedAngle;
using robotlink::Vector2;

namespace {

double directionOf(const Vector2& way) {
  return std::atan2(way.y(), way.x());
}

/// Decreases linearly from 1 at the obstacle to 0 at a distance.
double nearness(double distance, double range) {
  return range <= 0 ? 0 : std::clamp(1 - distance / range, 0.0, 1.0);
}

}  // namespace

PotentialField::PotentialField(const robotlink::FieldDescription& field)
    : goalX_(field.goalLineX()), touchY_(field.touchLineY()) {}

std::optional<Vector2> PotentialField::goal(const GameSituation& now) const {
  if (!now.pose) return std::nullopt;
  return now.pose->inverse() * Vector2(goalX_, 0);
}

Vector2 PotentialField::ballForce(const GameSituation& now, const Vector2& place) const {
  const Vector2 way = now.ball - place;
  const double distance = way.norm();
  if (!now.knowsBall || distance < 1e-6) return Vector2::Zero();
  const Vector2 toBall = way / distance;
  const Vector2 attraction =
      toBall * options_.attraction * std::clamp(distance / std::max(0.01, options_.slowing), 0.3, 1.0);
  const auto goalInRobot = goal(now);
  if (!goalInRobot) return attraction;
  // The angle between the way to the ball and that from the ball to the goal: 0 is right behind it.
  const double wrong = normalizedAngle(directionOf(*goalInRobot - now.ball) - directionOf(way));
  const double near = nearness(distance - options_.swirlRadius, options_.swirlRadius);
  const double share = near * std::clamp((std::abs(wrong) - 0.2) / 0.6, 0.0, 1.0);
  // If the goal is to the left of the ball, the way behind it leads to the right.
  const Vector2 along = wrong > 0 ? Vector2(toBall.y(), -toBall.x()) : Vector2(-toBall.y(), toBall.x());
  const double in = std::clamp(1.5 * (distance - options_.swirlRadius), -0.1, 0.1);
  return attraction * (1 - share) + (along * options_.swirl + toBall * in) * share;
}

Vector2 PotentialField::robotForce(const GameSituation& now, const Vector2& place) const {
  Vector2 sum = Vector2::Zero();
  for (const Vector2& robot : now.robots) {
    const Vector2 away = place - robot;
    const double distance = std::max(0.01, away.norm());
    sum += away / distance * options_.repulsion * nearness(distance - 0.15, options_.repulsionRadius - 0.15);
  }
  return sum;
}

Vector2 PotentialField::wallForce(const GameSituation& now, const Vector2& place) const {
  if (!now.pose) return Vector2::Zero();
  const Vector2 inTeam = *now.pose * place;
  Vector2 sum = Vector2::Zero();
  sum.x() +=
      nearness(inTeam.x() + goalX_, options_.wallRadius) - nearness(goalX_ - inTeam.x(), options_.wallRadius);
  sum.y() += nearness(inTeam.y() + touchY_, options_.wallRadius) -
             nearness(touchY_ - inTeam.y(), options_.wallRadius);
  return Eigen::Rotation2Dd(-now.pose->heading) * (sum * options_.wallRepulsion);
}

Vector2 PotentialField::force(const GameSituation& now, const Vector2& place) const {
  return ballForce(now, place) + robotForce(now, place) + wallForce(now, place);
}

bool PotentialField::canKick(const GameSituation& now) const {
  const auto goalInRobot = goal(now);
  return now.seesBall() && std::abs(now.ball.x() - options_.kickX) < options_.kickToleranceX &&
         std::abs(now.ball.y()) < options_.kickToleranceY &&
         (!goalInRobot || std::abs(directionOf(*goalInRobot - now.ball)) < options_.kickAngle);
}

Intention PotentialField::walk(const Vector2& velocity, double direction) const {
  Intention intention;
  intention.motion = Intention::Motion::kWalk;
  intention.turn = std::clamp(options_.turnGain * direction, -options_.turnSpeed, options_.turnSpeed);
  // A trot does not turn and walk well at the same time.
  const double share = std::clamp(1.6 - std::abs(intention.turn) / options_.turnSpeed, 0.2, 1.0);
  const double excess =
      std::max(1.0, std::hypot(velocity.x() / options_.forwardSpeed, velocity.y() / options_.sidewardSpeed));
  intention.forward = velocity.x() / excess * share;
  intention.left = velocity.y() / excess * share;
  intention.head = Intention::Head::kTrack;
  return intention;
}

Intention PotentialField::stand(const char* state, const char* reason) {
  state_ = state;
  reason_ = reason;
  return {};
}

Intention PotentialField::play(const GameSituation& now) {
  if (!now.knowsBall) {
    state_ = "turn about";
    reason_ = "the ball is not known";
    Intention intention;
    intention.motion = Intention::Motion::kWalk;
    intention.turn = options_.turnAbout;
    intention.head = Intention::Head::kSearch;
    return intention;
  }
  if (canKick(now)) {
    state_ = "kick";
    reason_ = "the ball is in front of the paws";
    Intention intention;
    intention.motion = Intention::Motion::kKick;
    intention.kick = options_.kick;
    intention.head = Intention::Head::kTrack;
    return intention;
  }
  const Vector2 velocity = force(now, Vector2::Zero());
  state_ = "flow";
  reason_ = "forces move it";
  // Near the ball it looks at it, far away at where it goes.
  const double near = nearness(now.ball.norm() - 0.3, 0.5);
  const double way = velocity.norm() < 0.02 ? 0 : directionOf(velocity);
  return walk(velocity, near * directionOf(now.ball) + (1 - near) * way);
}

Intention PotentialField::decide(const GameSituation& now) {
  using Phase = GameSituation::Phase;
  if (now.fallen) {
    Intention intention = stand("get up", "it has fallen");
    intention.motion = Intention::Motion::kGetUp;
    return intention;
  }
  if (now.pickedUp) return stand("stand", "it was picked up");
  if (now.penalized) return stand("stand", "the referee has penalized it");
  if (now.phase != Phase::kPlaying) return stand("stand", "the game is stopped");
  if (!now.seesField) {
    Intention intention = stand("stand", "nothing of the field is seen");
    intention.head = Intention::Head::kSearch;
    return intention;
  }
  // A kick is requested only until it begins, or it would be repeated.
  if (now.playsMotion) {
    Intention intention = stand("kick", reason_);
    intention.head = Intention::Head::kTrack;
    return intention;
  }
  return play(now);
}

}  // namespace modules
