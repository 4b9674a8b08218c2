// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the packages and messages that a referee publishes.
#pragma once

#include <memory>
#include <string>

#include "app/platforms/simulated/game/GameRules.h"
#include "robotlink/base/Clock.h"

namespace robotcontrol {
class GameState;
class GameStatus;
}  // namespace robotcontrol

namespace app {

class Referee;

/// Returns the referee's message to a robot; a robot that does not play gets what concerns all.
std::shared_ptr<robotcontrol::GameState> gameStateFor(const Referee& referee, const std::string& robot,
                                                      robotlink::Instant now);
/// Returns the referee's message to spectators.
std::shared_ptr<robotcontrol::GameStatus> gameStatus(const Referee& referee, const RadioSettings& radio,
                                                     robotlink::Instant now);

}  // namespace app
