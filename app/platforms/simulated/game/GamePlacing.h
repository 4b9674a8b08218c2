// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "app/platforms/simulated/game/GamePlayers.h"
#include "app/platforms/simulated/game/GameRules.h"

namespace robotlink {
struct FieldDescription;
}
namespace simcore {
class Simulation;
}

namespace app {

/// Puts robots and the ball of a simulated game to their places, as a person beside the field does, and says
/// where these are. `direction` is 1 if the player's team plays toward +x, otherwise -1. All arguments must
/// outlive it.
class GamePlacing {
 public:
  GamePlacing(const GameRules& rules, const robotlink::FieldDescription& field,
              simcore::Simulation& simulation)
      : rules_(rules), field_(field), simulation_(simulation) {}

  robotlink::Pose2 kickOffPlace(const GamePlayer& player, int direction, bool kicks) const;
  /// The pose of a player while it is penalized.
  robotlink::Pose2 penaltyPlace(const GamePlayer& player, int direction) const;
  /// Whether a player may stand where it does before a kick-off.
  bool mayStand(const GamePlayer& player, int direction, bool kicks) const;
  /// Unset if there is no such robot.
  std::optional<robotlink::Pose2> poseOf(const GamePlayer& player) const;

  /// Puts a robot on its feet there. False, changing nothing, if there is no room.
  bool put(const GamePlayer& player, const robotlink::Pose2& place);
  /// Puts a robot that was penalized to the edge of the field, in its own half. False if there is no room.
  bool putBack(const GamePlayer& player, int direction);
  /// Puts the ball to rest at a place, or as near as there is room. False if there is none.
  bool putBall(const std::string& ball, const robotlink::Vector2& place);

 private:
  const GameRules& rules_;
  const robotlink::FieldDescription& field_;
  simcore::Simulation& simulation_;
};

}  // namespace app
