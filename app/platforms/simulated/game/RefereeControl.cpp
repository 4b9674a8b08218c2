// SPDX-License-Identifier: GPL-3.0-or-later
// Referee: what a person asks of it.
#include <fmt/format.h>

#include <algorithm>

#include "app/platforms/simulated/game/Referee.h"
#include "robotcontrol/Game.pb.h"
#include "robotlink/base/TextParts.h"

namespace app {

using robotcontrol::ControlGame;
using robotlink::Result;
using Phase = GameMachine::Phase;

namespace {}  // namespace

Result<std::size_t> Referee::playerNamed(const std::string& robot) const {
  const auto found = std::ranges::find(players_, robot, &GamePlayer::robot);
  if (found != players_.end()) return static_cast<std::size_t>(found - players_.begin());
  return robotlink::failure("game.no-player", "no robot '" + robot + "' plays in this game", {}, {robot});
}

Result<std::size_t> Referee::teamNamed(const std::string& team) const {
  const auto found = std::ranges::find(rules_->teams, team);
  if (found != rules_->teams.end()) return static_cast<std::size_t>(found - rules_->teams.begin());
  return robotlink::failure("game.no-team",
                            "there is no team '" + team + "'; there are " + robotlink::joined(rules_->teams),
                            {}, {team});
}

Result<void> Referee::penalizeFor(const std::string& robot, const std::string& reason) {
  const auto player = playerNamed(robot);
  if (!player) return tl::unexpected(player.error());
  const auto* penalty = reason.empty() ? &rules_->penalties.front() : rules_->penalty(reason);
  if (penalty == nullptr)
    return robotlink::failure("game.no-reason", "the rules know no penalty for '" + reason + "'", {},
                              {reason});
  penalize(*player, *penalty);
  return {};
}

Result<void> Referee::bringBack(const std::string& robot) {
  const auto player = playerNamed(robot);
  if (!player) return tl::unexpected(player.error());
  if (!penalized_[*player])
    return robotlink::failure("game.not-penalized", robot + " is not penalized", {}, {robot});
  if (!returnPlayer(*player))
    return robotlink::failure("game.no-room", "there is no room for " + robot, {}, {robot});
  return {};
}

Result<void> Referee::setScore(const std::string& name, unsigned goals) {
  const auto team = teamNamed(name);
  if (!team) return tl::unexpected(team.error());
  machine_.setGoals(*team, goals);
  noteGoals();
  say(fmt::format("The {} team has {} goals.", name, goals));
  return {};
}

Result<void> Referee::giveKickOff(const std::string& name) {
  const auto team = teamNamed(name);
  if (!team) return tl::unexpected(team.error());
  if (machine_.phase() == Phase::kFinished)
    return robotlink::failure("game.half", "the half is over; set the kick-off when the next one has begun");
  machine_.setKickOff(*team);
  say(fmt::format("The {} team has the kick-off.", name));
  if (machine_.phase() == Phase::kPlaying) return enter(Phase::kReady);
  if (machine_.phase() == Phase::kSet) beginPlacing();
  return {};
}

Result<void> Referee::control(const ControlGame& wanted) {
  switch (wanted.action()) {
    case ControlGame::READY:
      return enter(Phase::kReady);
    case ControlGame::SET:
      return enter(Phase::kSet);
    case ControlGame::PLAY:
      return enter(Phase::kPlaying);
    case ControlGame::FINISH:
      return enter(Phase::kFinished);
    case ControlGame::RESTART:
      restart();
      say("The game starts over.");
      return {};
    case ControlGame::PENALIZE:
      return penalizeFor(wanted.robot(), wanted.reason());
    case ControlGame::RETURN:
      return bringBack(wanted.robot());
    case ControlGame::SCORE:
      return setScore(wanted.team(), wanted.goals());
    case ControlGame::KICK_OFF:
      return giveKickOff(wanted.team());
    case ControlGame::AUTOMATIC:
      isAutomatic_ = wanted.on();
      say(isAutomatic_ ? "The referee decides by itself." : "The user decides in place of the referee.");
      return {};
    default:
      return {};
  }
}

}  // namespace app
