// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/game/GamePlacing.h"

#include <cmath>

#include "app/platforms/simulated/game/FieldOfPlay.h"
#include "robotlink/config/FieldDescription.h"
#include "simcore/Simulation.h"

namespace app {

using robotlink::kPi;
using robotlink::Pose2;
using robotlink::Vector2;

namespace {

/// A place of the team that plays toward +x, as one of the other team.
Pose2 turned(const Vector2& place, double heading, int direction) {
  return {direction * place.x(), direction * place.y(),
          robotlink::normalizedAngle(direction > 0 ? heading : heading + kPi)};
}

/// The cosine of the tilt from which a robot is put on its feet.
constexpr double kUpright = 0.8;
/// The distance inside of the line at which robots come back.
constexpr double kReturnInset = 0.25;

}  // namespace

Pose2 GamePlacing::kickOffPlace(const GamePlayer& player, int direction, bool kicks) const {
  const auto& places = kicks ? rules_.kicking : rules_.waiting;
  if (player.isGoalie()) return turned(rules_.goalie, 0, direction);
  Vector2 place = places[player.fieldIndex % places.size()];
  // Players for whom there are no places stand behind the others.
  place.x() -= 0.4 * static_cast<double>(player.fieldIndex / places.size());
  return turned(place, 0, direction);
}

Pose2 GamePlacing::penaltyPlace(const GamePlayer& player, int direction) const {
  const double along = rules_.besideSpacing * player.number;
  const double beside = field_.touchLineY() + field_.wallThickness + rules_.besideField;
  return turned({-along, -beside}, 0.5 * kPi, direction);
}

std::optional<Pose2> GamePlacing::poseOf(const GamePlayer& player) const {
  const auto pose = simulation_.modelPose(player.robot);
  if (!pose) return std::nullopt;
  return robotlink::groundPose(*pose);
}

bool GamePlacing::mayStand(const GamePlayer& player, int direction, bool kicks) const {
  const auto pose = poseOf(player);
  if (!pose || !isRobotOnField(field_, pose->translation(), 0)) return false;
  if (direction * pose->x > 0) return false;
  return kicks || pose->translation().norm() > 0.5 * field_.centerCircleDiameter;
}

bool GamePlacing::put(const GamePlayer& player, const Pose2& place) {
  const auto pose = simulation_.modelPose(player.robot);
  if (!pose) return false;
  std::optional<simcore::ModelPosture> onItsFeet;
  if (pose->linear()(2, 2) < kUpright) onItsFeet = simcore::ModelPosture{.height = player.height};
  return simulation_.placeModel(player.robot, place, onItsFeet).has_value();
}

bool GamePlacing::putBack(const GamePlayer& player, int direction) {
  constexpr int kTries = 6;
  const double y = -(field_.touchLineY() - kReturnInset);
  for (int i = 0; i < kTries; ++i) {
    const double x = -0.3 * (i + 1);
    if (put(player, turned({x, y}, 0.5 * kPi, direction))) return true;
  }
  return false;
}

bool GamePlacing::putBall(const std::string& ball, const Vector2& place) {
  constexpr int kRings = 6, kDirections = 8;
  if (simulation_.placeModel(ball, {place.x(), place.y(), 0})) return true;
  for (int ring = 1; ring <= kRings; ++ring) {
    for (int i = 0; i < kDirections; ++i) {
      const double angle = 2 * kPi * i / kDirections;
      const Vector2 near = place + 0.08 * ring * Vector2(std::cos(angle), std::sin(angle));
      const Vector2 inside = nearestInside(field_, near, field_.ballRadius);
      if (simulation_.placeModel(ball, {inside.x(), inside.y(), 0})) return true;
    }
  }
  return false;
}

}  // namespace app
