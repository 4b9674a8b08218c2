// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/behavior/BallChaser.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace modules {

using robotlink::normalizedAngle;
using robotlink::Vector2;

namespace {

double bearing(const Vector2& place) {
  return std::atan2(place.y(), place.x());
}

/// The rotation toward an angle; slow near it, so that the gait does not oscillate.
double turnTo(double angle, double limit) {
  return std::clamp(1.6 * angle, -limit, limit);
}

}  // namespace

const char* name(BallChaser::State state) {
  static constexpr std::array<const char*, 10> kNames{
      "blind", "look about", "turn", "wander", "approach", "glance", "align", "position", "kick", "get up"};
  return kNames[static_cast<std::size_t>(state)];
}

void BallChaser::enter(State state, const char* reason, double time) {
  state_ = state;
  reason_ = reason;
  enteredAt_ = time;
  changed_ = true;
  kickBegan_ = false;
}

std::optional<double> BallChaser::misalignment(const Situation& now) const {
  if (!now.goal) return std::nullopt;
  return normalizedAngle(bearing(*now.goal - now.ball) - bearing(now.ball));
}

void BallChaser::transitSearch(const Situation& now) {
  const double since = now.time - enteredAt_;
  if (now.time - fieldSeenAt_ > options_.blindAfter) {
    if (state_ != State::kBlind) enter(State::kBlind, "nothing of the field is seen: stand still", now.time);
  } else if (seesBall(now)) {
    enter(State::kApproach, "the ball is seen", now.time);
  } else if (state_ == State::kBlind) {
    enter(State::kLookAbout, "the field is seen again", now.time);
  } else if (state_ == State::kLookAbout && since > options_.lookAboutTime) {
    turnDirection_ = now.ball.y() < 0 ? -1 : 1;
    enter(State::kTurn, "the head cannot point at the ball: turn", now.time);
  } else if (state_ == State::kTurn && since > options_.turnTime) {
    enter(State::kWander, "no ball in any direction: look from elsewhere", now.time);
  } else if (state_ == State::kWander && since > options_.wanderTime) {
    enter(State::kLookAbout, "look from here", now.time);
  }
}

void BallChaser::transitChase(const Situation& now) {
  const double since = now.time - enteredAt_;
  const double distance = now.ball.norm();
  const auto off = misalignment(now);
  const bool aligned = !off || std::abs(*off) < options_.alignTolerance;
  if (!now.ballKnown || now.ballAge > options_.lostAfter) {
    enter(State::kLookAbout, "the ball is lost", now.time);
  } else if (state_ == State::kApproach) {
    if (distance > options_.alignDistance + 0.05) return;
    if (!off && now.time - glancedAt_ > options_.glanceAgain)
      enter(State::kGlance, "near the ball, but where is the goal?", now.time);
    else if (aligned)
      enter(State::kPosition, off ? "the goal is behind the ball" : "near the ball, the goal is not known",
            now.time);
    else
      enter(State::kAlign, "near the ball, but the goal is elsewhere", now.time);
  } else if (state_ == State::kGlance) {
    glancedAt_ = now.time;
    if (off || since > options_.glanceTime)
      enter(State::kApproach, off ? "there is the goal" : "no beacon tells where the goal is", now.time);
  } else if (distance > options_.alignDistance + 0.2) {
    enter(State::kApproach, "the ball is away", now.time);
  } else if (state_ == State::kAlign) {
    if (aligned || since > options_.alignTime)
      enter(State::kPosition, aligned ? "the goal is behind the ball" : "aligning takes too long", now.time);
  } else if (std::abs(now.ball.x() - options_.kickX) < options_.kickToleranceX &&
             std::abs(now.ball.y() - options_.kickY) < options_.kickToleranceY && now.ballAge < 0.5) {
    enter(State::kKick, "the ball is in front of the paws", now.time);
  } else if (since > options_.positionTime) {
    enter(State::kApproach, "the ball was not reached: start over", now.time);
  }
}

void BallChaser::transitKick(const Situation& now) {
  if (now.kicking) kickBegan_ = true;
  const double since = now.time - enteredAt_;
  if (kickBegan_ && !now.kicking)
    enter(State::kLookAbout, "kicked: where is the ball now?", now.time);
  else if (since > options_.kickTimeout)
    enter(State::kLookAbout, "the kick did not end", now.time);
}

void BallChaser::transit(const Situation& now) {
  if (now.fallen) {
    if (state_ != State::kGetUp) enter(State::kGetUp, "fallen", now.time);
    return;
  }
  switch (state_) {
    case State::kGetUp:
      if (now.stable) enter(State::kLookAbout, "on its paws again", now.time);
      break;
    case State::kKick:
      transitKick(now);
      break;
    case State::kApproach:
    case State::kGlance:
    case State::kAlign:
    case State::kPosition:
      transitChase(now);
      break;
    default:
      transitSearch(now);
  }
}

Intention BallChaser::walk(const Vector2& way, double turn, double speedShare) const {
  Intention intention;
  intention.motion = Intention::Motion::kWalk;
  // Keeps the direction if one of the two speeds is at its limit.
  const double excess = std::max({1.0, std::abs(way.x()) / (options_.forwardSpeed * speedShare),
                                  std::abs(way.y()) / (options_.sidewardSpeed * speedShare)});
  intention.forward = way.x() / excess;
  intention.left = way.y() / excess;
  intention.turn = std::clamp(turn, -options_.turnSpeed, options_.turnSpeed);
  intention.head = Intention::Head::kTrack;
  return intention;
}

Intention BallChaser::approach(const Situation& now) {
  const double distance = now.ball.norm();
  Vector2 place = now.ball * std::max(0.0, 1 - options_.alignDistance / std::max(0.01, distance));
  const auto off = misalignment(now);
  if (off && distance > options_.alignDistance) {
    // A position behind the ball. The detour grows with the angle, but never passes the far side of the ball.
    const double bend = std::clamp(*off, -1.2, 1.2);
    const Vector2 behind = Eigen::Rotation2Dd(bend) * (-now.ball.normalized()) * options_.alignDistance;
    place = now.ball + behind;
  }
  target_ = place;
  const double direction = bearing(distance > 0.6 ? place : now.ball);
  Intention intention = walk(place * 3, turnTo(direction, options_.turnSpeed), 1);
  // First turn, then walk: a trot does not turn and walk well at the same time.
  const double share = std::clamp(1.5 - std::abs(bearing(now.ball)) / 0.6, 0.0, 1.0);
  intention.forward *= share;
  intention.left *= share;
  return intention;
}

Intention BallChaser::align(const Situation& now) const {
  const double off = misalignment(now).value_or(0);
  // Circling: sideways along the circle, while turning so that the ball stays ahead. If the goal is to the
  // left, walk to the right.
  const double along = off > 0 ? -options_.sidewardSpeed : options_.sidewardSpeed;
  const double distance = std::max(0.15, now.ball.norm());
  const double in = 1.2 * (distance - options_.alignDistance);
  return walk({in, along}, -along / distance + turnTo(bearing(now.ball), options_.turnSpeed), 1);
}

Intention BallChaser::position(const Situation& now) const {
  const Vector2 way(now.ball.x() - options_.kickX, now.ball.y() - options_.kickY);
  // Sideways first, so that no paw pushes the ball away.
  const double free = std::abs(way.y()) > 0.06 ? 0.3 : 1.0;
  const double turn = now.ball.norm() > 0.22 ? 0.7 * bearing(now.ball) : 0;
  return walk({1.5 * way.x() * free, 1.5 * way.y()}, turn, 0.5);
}

Intention BallChaser::act(const Situation& now) {
  target_.reset();
  Intention intention;
  switch (state_) {
    case State::kBlind:
    case State::kLookAbout:
      intention.head = Intention::Head::kSearch;
      return intention;
    case State::kGlance:
      intention.head = Intention::Head::kLookAround;
      return intention;
    case State::kTurn:
      intention.motion = Intention::Motion::kWalk;
      intention.turn = turnDirection_ * options_.turnSpeed;
      intention.head = Intention::Head::kSearch;
      return intention;
    case State::kWander:
      intention.motion = Intention::Motion::kWalk;
      intention.forward = options_.wanderSpeed;
      intention.head = Intention::Head::kSearch;
      return intention;
    case State::kApproach:
      return approach(now);
    case State::kAlign:
      return align(now);
    case State::kPosition:
      return position(now);
    case State::kKick:
      // Requested only until it begins: a motion that is still requested when it ends is repeated.
      intention.motion = kickBegan_ ? Intention::Motion::kStand : Intention::Motion::kKick;
      intention.head = Intention::Head::kTrack;
      return intention;
    case State::kGetUp:
      intention.motion = Intention::Motion::kGetUp;
      return intention;
  }
  return intention;
}

Intention BallChaser::decide(const Situation& now) {
  changed_ = false;
  if (!started_) {
    started_ = true;
    fieldSeenAt_ = now.time;
    enter(State::kLookAbout, "the game begins", now.time);
  }
  if (now.fieldSeen) fieldSeenAt_ = now.time;
  transit(now);
  return act(now);
}

}  // namespace modules
