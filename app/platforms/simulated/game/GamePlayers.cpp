// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/game/GamePlayers.h"

#include <algorithm>
#include <cstdlib>

#include "app/platforms/simulated/game/GameRules.h"
#include "simcore/Scene.h"

namespace app {
namespace {

constexpr unsigned kMaxPlayers = 1000;

/// The number in a name; 0 if there is none, or no sensible one.
unsigned numberIn(const std::string& name) {
  const std::size_t last = name.find_last_not_of("0123456789");
  const std::string digits = last == std::string::npos ? name : name.substr(last + 1);
  const unsigned long number = digits.size() > 4 ? 0 : std::strtoul(digits.c_str(), nullptr, 10);
  return number < kMaxPlayers ? static_cast<unsigned>(number) : 0;
}

bool isTaken(const std::vector<GamePlayer>& players, std::size_t team, unsigned number) {
  return std::ranges::any_of(
      players, [&](const GamePlayer& player) { return player.team == team && player.number == number; });
}

void countFieldPlayers(std::vector<GamePlayer>& players) {
  for (GamePlayer& player : players) {
    player.fieldIndex = static_cast<std::size_t>(std::ranges::count_if(players, [&](const auto& other) {
      return other.team == player.team && !other.isGoalie() && other.number < player.number;
    }));
  }
}

}  // namespace

std::vector<GamePlayer> playersOf(const simcore::Scene& scene, const GameRules& rules) {
  std::vector<GamePlayer> players;
  for (const auto& robot : scene.robots()) {
    const auto team = std::ranges::find(rules.teams, robot.team);
    if (team == rules.teams.end()) continue;
    GamePlayer player{.robot = robot.name,
                      .team = static_cast<std::size_t>(team - rules.teams.begin()),
                      .number = numberIn(robot.name),
                      .role = robot.role};
    if (player.number == 0 || isTaken(players, player.team, player.number)) {
      player.number = 1;
      while (isTaken(players, player.team, player.number)) ++player.number;
    }
    players.push_back(std::move(player));
  }
  countFieldPlayers(players);
  return players;
}

}  // namespace app
