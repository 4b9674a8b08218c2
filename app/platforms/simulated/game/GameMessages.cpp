// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/game/GameMessages.h"

#include <algorithm>

#include "app/platforms/simulated/game/Referee.h"
#include "robotcontrol/Game.pb.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/packages/Conversions.h"

namespace app {
namespace {

using robotcontrol::GameState;

GameState::Phase phaseOf(GameMachine::Phase phase) {
  switch (phase) {
    case GameMachine::Phase::kReady:
      return GameState::READY;
    case GameMachine::Phase::kSet:
      return GameState::SET;
    case GameMachine::Phase::kPlaying:
      return GameState::PLAYING;
    case GameMachine::Phase::kFinished:
      return GameState::FINISHED;
    default:
      return GameState::INITIAL;
  }
}

/// The name of the goal at a side, 1 or -1.
std::string goalAt(const robotlink::FieldDescription& field, int side) {
  const auto goal = std::ranges::find_if(field.goals, [&](const auto& one) { return one.x * side > 0; });
  return goal == field.goals.end() ? std::string() : goal->name;
}

void describeGame(const Referee& referee, robotlink::Instant now, GameState& state) {
  const GameRules& rules = referee.rules();
  const GameMachine& machine = referee.machine();
  robotlink::assign(*state.mutable_timestamp(), now);
  state.set_phase(phaseOf(machine.phase()));
  for (std::size_t i = 0; i < rules.teams.size(); ++i) {
    auto& team = *state.add_teams();
    team.set_name(rules.teams[i]);
    team.set_goals(machine.goals(i));
    team.set_attacks(goalAt(referee.field(), machine.direction(i)));
  }
  state.set_kick_off(rules.teams[machine.kickOff()]);
  state.set_half(machine.half());
  state.set_seconds_left(robotlink::seconds(machine.left()));
  for (std::size_t i = 0; i < referee.players().size(); ++i) {
    const auto& penalized = referee.penaltyOf(i);
    if (!penalized) continue;
    auto& penalty = *state.add_penalties();
    penalty.set_robot(referee.players()[i].robot);
    penalty.set_reason(penalized->penalty->reason);
    penalty.set_seconds(robotlink::seconds(penalized->left));
  }
  state.set_message(referee.message());
}

}  // namespace

std::shared_ptr<GameState> gameStateFor(const Referee& referee, const std::string& robot,
                                        robotlink::Instant now) {
  auto state = std::make_shared<GameState>();
  describeGame(referee, now, *state);
  const auto& players = referee.players();
  const auto player = std::ranges::find(players, robot, &GamePlayer::robot);
  state->set_robot(robot);
  if (player == players.end()) return state;
  state->set_team(referee.rules().teams[player->team]);
  state->set_number(player->number);
  state->set_role(player->role);
  state->set_penalized(referee.penaltyOf(static_cast<std::size_t>(player - players.begin())).has_value());
  return state;
}

std::shared_ptr<robotcontrol::GameStatus> gameStatus(const Referee& referee, const RadioSettings& radio,
                                                     robotlink::Instant now) {
  auto status = std::make_shared<robotcontrol::GameStatus>();
  robotlink::assign(*status->mutable_timestamp(), now);
  describeGame(referee, now, *status->mutable_state());
  for (const GamePlayer& player : referee.players()) {
    auto& one = *status->add_players();
    one.set_robot(player.robot);
    one.set_team(referee.rules().teams[player.team]);
    one.set_number(player.number);
    one.set_role(player.role);
  }
  for (const auto& penalty : referee.rules().penalties) status->add_reasons(penalty.reason);
  status->mutable_radio()->set_range(radio.range);
  status->mutable_radio()->set_delay(radio.delay);
  status->mutable_radio()->set_loss(radio.loss);
  status->set_automatic(referee.isAutomatic());
  status->set_rules(referee.rules().title);
  return status;
}

}  // namespace app
