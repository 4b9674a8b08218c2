// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/game/FoulWatch.h"

#include <algorithm>

#include "app/platforms/simulated/game/FieldOfPlay.h"
#include "app/platforms/simulated/game/GameTime.h"
#include "robotlink/config/FieldDescription.h"

namespace app {

using robotlink::Duration;
using robotlink::Vector2;

namespace {

/// Robots whose centers are farther apart, m, cannot touch.
constexpr double kReach = 0.45;
/// The share of the pusher's speed with which the other one gives way.
constexpr double kGivesWay = 0.3;

}  // namespace

void FoulWatch::restart(std::size_t robots) {
  histories_.assign(robots, {});
}

void FoulWatch::forget(std::size_t robot) {
  histories_[robot] = {};
}

Vector2 FoulWatch::velocity(const Robot& robot) const {
  const auto& before = histories_[robot.index].place;
  if (!before) return Vector2::Zero();
  return (robot.place - *before) / robotlink::seconds(kEvery);
}

bool FoulWatch::pushes(const Robot& robot, const std::vector<Robot>& all, const std::optional<Vector2>& ball,
                       const Touching& touching) const {
  if (ball && (*ball - robot.place).norm() < rules_.pushingNearBall) return false;
  if (robot.isGoalie && isInPenaltyArea(field_, robot.place, robot.ownSide)) return false;
  return std::ranges::any_of(all, [&](const Robot& other) {
    const Vector2 way = other.place - robot.place;
    if (other.team == robot.team || way.norm() > kReach || way.norm() < 1e-6) return false;
    const double toward = velocity(robot).dot(way.normalized());
    if (toward < rules_.pushingSpeed) return false;
    if (velocity(other).dot(way.normalized()) < kGivesWay * toward) return false;
    return touching(robot.index, other.index);
  });
}

bool FoulWatch::defendsIllegally(const Robot& robot, const std::vector<Robot>& all) const {
  const auto isHome = [this](const Robot& one) { return isInPenaltyArea(field_, one.place, one.ownSide); };
  return !robot.isGoalie && isHome(robot) && std::ranges::any_of(all, [&](const Robot& other) {
    return other.team == robot.team && other.isGoalie && isHome(other);
  });
}

std::vector<FoulWatch::Foul> FoulWatch::look(const std::vector<Robot>& robots,
                                             const std::optional<Vector2>& ball, const Touching& touching) {
  std::vector<Foul> fouls;
  const auto count = [&](Duration& lasted, bool is, Duration otherwise, GameRules::Watch watch,
                         std::size_t robot) {
    const GameRules::Penalty* penalty = rules_.penaltyFor(watch);
    if (penalty == nullptr) return;
    lasted = is ? lasted + kEvery : std::max(Duration(), lasted - otherwise);
    if (lasted < penalty->after || lasted == Duration()) return;
    lasted = {};
    fouls.push_back({robot, penalty});
  };
  for (const Robot& robot : robots) {
    History& history = histories_[robot.index];
    const bool isOutside = !isRobotOnField(field_, robot.place, rules_.leavingMargin);
    count(history.outside, isOutside, history.outside, GameRules::Watch::kLeaving, robot.index);
    const bool defends = defendsIllegally(robot, robots);
    count(history.defending, defends, history.defending, GameRules::Watch::kDefending, robot.index);
    const bool holds = ball && (*ball - robot.place).norm() < rules_.holdingDistance;
    count(history.holding, holds, history.holding, GameRules::Watch::kHolding, robot.index);
    count(history.pushing, pushes(robot, robots, ball, touching), kEvery, GameRules::Watch::kPushing,
          robot.index);
  }
  for (const Robot& robot : robots) histories_[robot.index].place = robot.place;
  return fouls;
}

void FoulWatch::transfer(simcore::StateStream& stream) {
  for (History& history : histories_) {
    for (Duration* time : {&history.outside, &history.pushing, &history.defending, &history.holding})
      transferTime(stream, *time);
    bool isKnown = history.place.has_value();
    stream.flag(isKnown);
    Vector2 place = history.place.value_or(Vector2::Zero());
    stream.number(place.x());
    stream.number(place.y());
    if (stream.good()) history.place = isKnown ? std::optional(place) : std::nullopt;
  }
}

}  // namespace app
