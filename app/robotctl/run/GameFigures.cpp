// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/run/GameFigures.h"

#include <algorithm>

#include "app/platforms/simulated/SimulatedRun.h"

namespace app {
namespace {

using nlohmann::json;

const char* nameOf(GameMachine::Phase phase) {
  switch (phase) {
    case GameMachine::Phase::kReady:
      return "ready";
    case GameMachine::Phase::kSet:
      return "set";
    case GameMachine::Phase::kPlaying:
      return "playing";
    case GameMachine::Phase::kFinished:
      return "finished";
    default:
      return "initial";
  }
}

json playersJson(const Referee& referee) {
  json players = json::array();
  for (std::size_t i = 0; i < referee.players().size(); ++i) {
    const GamePlayer& player = referee.players()[i];
    const Referee::Tally& tally = referee.tallyOf(i);
    json one{{"robot", player.robot},
             {"team", referee.rules().teams[player.team]},
             {"number", player.number},
             {"penalties", tally.penalties},
             {"longest_outside_seconds", robotlink::seconds(tally.longestOutside)},
             {"fallen_seconds", robotlink::seconds(tally.fallen)}};
    if (!player.role.empty()) one["role"] = player.role;
    players.push_back(std::move(one));
  }
  return players;
}

}  // namespace

void addGameFigures(const SimulatedRun& run, json& figures) {
  if (run.game() == nullptr) return;
  figures["goals"] = run.game()->goals();
  figures["score"] = figures["goals"];
  const Referee* referee = run.referee();
  if (referee == nullptr) return;
  const GameMachine& machine = referee->machine();
  figures["game"] = {{"rules", referee->rules().title},
                     {"teams", referee->rules().teams},
                     {"phase", nameOf(machine.phase())},
                     {"half", machine.half()},
                     {"seconds_left", robotlink::seconds(machine.left())},
                     {"players", playersJson(*referee)},
                     {"messages_sent", run.radio().sent()},
                     {"messages_lost", run.radio().lost()}};
}

}  // namespace app
