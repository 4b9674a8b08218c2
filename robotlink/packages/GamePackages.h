// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/packages/Packages.h"

namespace robotcontrol {
class BehaviorGraph;
class FieldLinePercepts;
class GameState;
class RobotState;
class TeamBall;
class TeamMessage;
class TeamMessages;
}  // namespace robotcontrol

namespace robotlink {

/// The state of the game from the referee, which the platform sends; see Game.proto.
inline constexpr Package<robotcontrol::GameState> kGameState{"game/state"};
/// The robot's message to its team, for the platform.
inline constexpr Package<robotcontrol::TeamMessage> kTeamMessage{"team/message"};
/// Messages of the others of its team, from the platform.
inline constexpr Package<robotcontrol::TeamMessages> kTeamMessages{"team/messages"};
/// Lines of the field seen in one image.
inline constexpr Package<robotcontrol::FieldLinePercepts> kFieldLines{"percepts/lines"};
/// Whether the robot was picked up, has fallen, or touches something.
inline constexpr Package<robotcontrol::RobotState> kRobotState{"percepts/robot-state"};
/// The true state of the robot's body, from a simulated platform.
inline constexpr Package<robotcontrol::RobotState> kOracleState{"oracle/state"};
/// The ball as the team sees it.
inline constexpr Package<robotcontrol::TeamBall> kTeamBall{"models/team-ball"};
/// The options of the behavior, sent only on request.
inline constexpr Package<robotcontrol::BehaviorGraph> kBehaviorGraph{"behavior/graph"};

}  // namespace robotlink
