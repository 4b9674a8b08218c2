// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace simcore {
class Scene;
}

namespace app {

struct GameRules;

/// A robot of one of the two teams of a game. A plain value.
struct GamePlayer {
  /// The scene's name for the role of a goalkeeper.
  static constexpr char kGoalie[] = "goalie";

  std::string robot;
  /// An index into GameRules::teams.
  std::size_t team = 0;
  /// In its team, from 1.
  unsigned number = 1;
  /// The role that the scene gives it; may be empty.
  std::string role = {};
  /// The height of its model at the start, m.
  double height = 0;
  /// Counts the players of its team that keep no goal, in the order of their numbers, from 0.
  std::size_t fieldIndex = 0;

  bool isGoalie() const { return role == kGoalie; }
};

/// The robots of a scene that play in the teams of these rules, in the order of the scene. A robot's number
/// is that at the end of its name, if no other one of its team has it, otherwise the first that is free.
std::vector<GamePlayer> playersOf(const simcore::Scene& scene, const GameRules& rules);

}  // namespace app
