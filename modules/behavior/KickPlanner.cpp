// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/behavior/KickPlanner.h"

#include <algorithm>
#include <cmath>

namespace modules {

using robotlink::kPi;
using robotlink::normalizedAngle;
using robotlink::Vector2;

namespace {

constexpr KickKind kKicks[] = {KickKind::kAhead, KickKind::kFarAhead, KickKind::kLeft, KickKind::kRight};

/// The directions that are compared, all around; the number after them is the direct one to the goal.
constexpr int kCircle = 24;
/// How far a rolling ball is followed at a time, m, and how far its middle is from a wall that it touches.
constexpr double kRollStep = 0.1, kBallRadius = 0.042;
/// A ball nearer to a wall than this counts as next to it, m.
constexpr double kBesideWall = 0.2;
/// The distance that a place behind the ball may be within a wall before there is no room, m.
constexpr double kTight = 0.02;
/// A ball stops at a robot whose center is nearer, m, and a robot that is this near to a place occupies it.
constexpr double kStops = 0.14, kOccupies = 0.22;
/// The cost of a ball that rolls into the own goal, s.
constexpr double kOwnGoal = 100;

double wayAngle(const Vector2& way) {
  return std::atan2(way.y(), way.x());
}

Vector2 towards(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

bool isOpponentAtBall(const KickPlanner::Situation& now, double distance) {
  return std::ranges::any_of(now.opponents,
                             [&](const Vector2& robot) { return (robot - now.ball).norm() < distance; });
}

}  // namespace

/// The cost of the way behind the ball, and of pushing an opponent away from there.
double KickPlanner::secondsBehind(const Situation& now, double heading) const {
  const Vector2 behind = now.ball - towards(heading) * now.skills.options().standOff;
  const bool isOccupied = std::ranges::any_of(
      now.opponents, [&](const Vector2& robot) { return (robot - behind).norm() < kOccupies; });
  const double haste = isOpponentAtBall(now, options_.hasteDistance) ? options_.haste : 1;
  const Vector2 ball = now.robot.inverse() * now.ball;
  return haste * now.skills.secondsTo(ball, normalizedAngle(heading - now.robot.heading)) +
         (isOccupied ? options_.occupiedSeconds : 0);
}

/// Whether a robot that the ball comes nearer to stops it.
bool KickPlanner::isStopped(const Situation& now, const Vector2& from, const Vector2& to) {
  const auto stops = [&](const Vector2& robot) {
    const double apart = (robot - to).norm();
    return apart < kStops && apart < (robot - from).norm();
  };
  return std::ranges::any_of(now.opponents, stops) || std::ranges::any_of(now.mates, stops);
}

bool KickPlanner::hasTime(const Situation& now, KickKind kind) const {
  if (kind != KickKind::kFarAhead) return true;
  return options_.farClearance > 0 && !isOpponentAtBall(now, options_.farClearance);
}

double KickPlanner::lengthOf(KickKind kind) const {
  if (kind == KickKind::kAhead) return options_.kickLength;
  return kind == KickKind::kFarAhead ? options_.farLength : options_.sideLength;
}

double KickPlanner::spreadOf(KickKind kind) const {
  if (kind == KickKind::kAhead) return options_.kickSpread;
  return kind == KickKind::kFarAhead ? options_.farSpread : options_.sideSpread;
}

/// The time from a kick on, for which the ball is followed as it rolls, along walls too.
double KickPlanner::secondsAfter(const Situation& now, const Choice& choice) const {
  const Vector2 goal = places_.opponentGoal();
  const double half = 0.5 * places_.goalWidth() - kBallRadius - 0.04;
  const double length = lengthOf(choice.kind);
  const Vector2 step = kRollStep * towards(choice.direction);
  Vector2 ball = now.ball;
  bool stopped = false;
  for (double way = 0; way < length; way += kRollStep) {
    const Vector2 next = ball + step;
    if (std::abs(next.x()) > goal.x() - kBallRadius && std::abs(next.y()) < half)
      return next.x() > 0 ? 0 : kOwnGoal;
    stopped = isStopped(now, ball, next);
    if (stopped) break;
    ball = places_.within(next, kBallRadius);
  }
  const bool isBesideWall = (places_.within(ball, kBesideWall) - ball).norm() > 0.01;
  const double turn = std::abs(normalizedAngle(wayAngle(goal - ball) - choice.heading()));
  return options_.secondsPerKick + options_.secondsPerMeter * (goal - ball).norm() +
         turn * now.skills.options().standOff / now.skills.options().sidewardSpeed +
         (isBesideWall ? options_.wallSeconds : 0) + (stopped ? options_.stoppedSeconds : 0);
}

std::optional<double> KickPlanner::secondsToGoal(const Situation& now, const Choice& choice) const {
  if (!hasTime(now, choice.kind)) return std::nullopt;
  const Vector2 behind = now.ball - towards(choice.heading()) * now.skills.options().standOff;
  if ((places_.reachable(behind) - behind).norm() > kTight) return std::nullopt;
  // The mean over the spread, by the three points of a Gauss-Hermite quadrature.
  const double aside = std::sqrt(3.0) * spreadOf(choice.kind);
  const double after =
      (4 * secondsAfter(now, choice) + secondsAfter(now, {choice.kind, choice.direction - aside}) +
       secondsAfter(now, {choice.kind, choice.direction + aside})) /
      6;
  return secondsBehind(now, choice.heading()) + after +
         (choice.kind == KickKind::kFarAhead ? options_.farSeconds : 0);
}

KickPlanner::Choice KickPlanner::choose(const Situation& now, bool keeps) {
  const Vector2 way = places_.aim(now.ball, now.opponents) - now.ball;
  const double toGoal = way.norm() < 0.05 ? 0 : wayAngle(way);
  const auto choiceOf = [&](const std::pair<KickKind, int>& one) {
    return Choice{one.first, one.second == kCircle ? toGoal : 2 * kPi * one.second / kCircle};
  };
  if (keeps && last_ && hasTime(now, last_->first)) return choiceOf(*last_);
  std::pair best(KickKind::kAhead, kCircle);
  std::optional<double> least;
  for (const KickKind kind : kKicks) {
    for (int number = kCircle; number >= 0; --number) {
      const std::pair one(kind, number);
      auto seconds = secondsToGoal(now, choiceOf(one));
      if (!seconds) continue;
      if (one == last_) *seconds -= options_.keepSeconds;
      if (!least || *seconds < *least) {
        least = seconds;
        best = one;
      }
    }
  }
  last_ = best;
  return choiceOf(best);
}

}  // namespace modules
