// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/behavior/TeamPlaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "robotlink/config/FieldDescription.h"

namespace modules {

using robotlink::Pose2;
using robotlink::Vector2;

namespace {

/// Half the width of a robot and a ball, m: what a gap must have on both sides.
constexpr double kHalfRobot = 0.13;

constexpr std::array<std::pair<Role, const char*>, 5> kRoleNames{{{Role::kNone, ""},
                                                                  {Role::kGoalie, "goalie"},
                                                                  {Role::kDefender, "defender"},
                                                                  {Role::kSupporter, "supporter"},
                                                                  {Role::kStriker, "striker"}}};

}  // namespace

const char* name(Role role) {
  for (const auto& [known, word] : kRoleNames)
    if (known == role) return word;
  return "";
}

Role roleOf(const std::string& word) {
  for (const auto& [role, known] : kRoleNames)
    if (word == known) return role;
  return Role::kNone;
}

TeamPlaces::TeamPlaces(const robotlink::FieldDescription& field, const Options& options)
    : options_(options),
      goalX_(field.goalLineX()),
      touchY_(field.touchLineY()),
      goalWidth_(field.goalWidth),
      penaltyLength_(field.penaltyAreaLength),
      penaltyWidth_(field.penaltyAreaWidth),
      cornerSide_(field.cornerTriangleSide),
      kickOff_(field.kickOff) {
  std::ranges::stable_sort(kickOff_, [](const Pose2& a, const Pose2& b) { return a.x > b.x; });
  if (kickOff_.empty()) kickOff_.push_back({-0.4 * goalX_, 0, 0});
}

Pose2 TeamPlaces::facing(const Vector2& place, const Vector2& ball) const {
  const Vector2 way = ball - place;
  return {place.x(), place.y(), std::atan2(way.y(), way.x())};
}

Pose2 TeamPlaces::kickOff(int number, bool isGoalie) const {
  if (isGoalie) return kickOff_.back();
  const int fieldPlayers = std::max(1, static_cast<int>(kickOff_.size()) - 1);
  return kickOff_[static_cast<std::size_t>(std::max(0, number - 2) % fieldPlayers)];
}

Pose2 TeamPlaces::goalie(const Vector2& ball) const {
  const double x = -goalX_ + options_.goalieDistance;
  // The place is on the line from the ball to the middle of the goal, so that both corners are as far.
  const Vector2 way = ball - ownGoal();
  const double y = way.x() > 0.05 ? way.y() * options_.goalieDistance / way.x() : 10 * way.y();
  const double limit = 0.5 * goalWidth_ - 0.08;
  const Vector2 place(x, std::clamp(y, -limit, limit));
  Pose2 pose = facing(place, ball);
  pose.heading = std::clamp(pose.heading, -1.2, 1.2);
  return pose;
}

Pose2 TeamPlaces::defender(const Vector2& ball) const {
  const Vector2 way = ownGoal() - ball;
  const double distance = std::max(0.01, way.norm());
  Vector2 place = ball + way / distance * std::min(options_.defenderDistance, distance);
  // The penalty area is the goalie's.
  place.x() = std::clamp(place.x(), -goalX_ + penaltyLength_ + 0.2, -0.2);
  return facing(inside(place), ball);
}

Pose2 TeamPlaces::supporter(const Vector2& ball) const {
  const double side = ball.y() > 0 ? -1 : 1;
  // No robot scores from the corners next to the goal: it waits before the goal for passes from there.
  if (ball.x() > 0.5 * goalX_ && std::abs(ball.y()) > options_.supporterAside)
    return facing({goalX_ - options_.beforeGoal, 0.1 * side}, ball);
  // Near the own goal it waits before the ball, where it is in nobody's way, and where cleared balls arrive.
  const double along = ball.x() < -0.5 * goalX_ ? std::abs(options_.supporterBack) : -options_.supporterBack;
  const Vector2 place(std::clamp(ball.x() + along, -goalX_ + penaltyLength_ + 0.2, goalX_),
                      ball.y() + side * options_.supporterAside);
  return facing(inside(place), ball);
}

Pose2 TeamPlaces::beforeArea(const Vector2& ball) const {
  return facing({-goalX_ + penaltyLength_ + options_.beforeGoal, 0.5 * ball.y()}, ball);
}

Vector2 TeamPlaces::aim(const Vector2& ball, const std::vector<Vector2>& robots) const {
  const double half = 0.5 * goalWidth_ - 0.08;
  // Shadows of robots on the goal line, seen from the ball.
  std::vector<std::pair<double, double>> shadows;
  for (const Vector2& robot : robots) {
    const double ahead = robot.x() - ball.x();
    if (ahead < 0.1 || robot.x() > goalX_ + 0.1) continue;
    const double scale = (goalX_ - ball.x()) / ahead;
    const double y = ball.y() + (robot.y() - ball.y()) * scale;
    shadows.emplace_back(y - kHalfRobot * scale, y + kHalfRobot * scale);
  }
  std::ranges::sort(shadows);
  double bestY = 0, bestWidth = 0, from = -half;
  const auto consider = [&](double to) {
    if (to - from > bestWidth + 1e-9) {
      bestWidth = to - from;
      bestY = 0.5 * (from + to);
    }
  };
  for (const auto& [low, high] : shadows) {
    if (high < -half || low > half) continue;
    consider(std::min(low, half));
    from = std::max(from, high);
  }
  if (from < half) consider(half);
  if (bestWidth < 0.1) bestY = 0;  // no gap is wide enough: the middle is as good
  return {goalX_, bestY};
}

bool TeamPlaces::isGoaliesBall(const Vector2& ball, double margin) const {
  return ball.x() < -goalX_ + penaltyLength_ + margin && std::abs(ball.y()) < 0.5 * penaltyWidth_ + margin;
}

bool TeamPlaces::isOutside(const Vector2& place) const {
  return std::abs(place.x()) > goalX_ || std::abs(place.y()) > touchY_;
}

Vector2 TeamPlaces::inside(const Vector2& place) const {
  const double x = goalX_ - options_.wallDistance, y = touchY_ - options_.wallDistance;
  return {std::clamp(place.x(), -x, x), std::clamp(place.y(), -y, y)};
}

Vector2 TeamPlaces::reachable(const Vector2& place) const {
  return within(place, kHalfRobot);
}

Vector2 TeamPlaces::within(const Vector2& place, double distance) const {
  const double x = goalX_ - distance, y = touchY_ - distance;
  Vector2 result(std::clamp(place.x(), -x, x), std::clamp(place.y(), -y, y));
  // The triangles in the corners, whose ramps a robot does not climb.
  const double beyond = std::abs(result.x()) + std::abs(result.y()) -
                        (goalX_ + touchY_ - cornerSide_ - distance * std::numbers::sqrt2);
  if (beyond > 0)
    result -= 0.5 * beyond * Vector2(std::copysign(1, result.x()), std::copysign(1, result.y()));
  return result;
}

}  // namespace modules
