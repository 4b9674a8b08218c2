// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/behavior/SoccerMind.h"

namespace modules {

/// Builds the options of a soccer player, from the bottom to the top: skills, roles, the game. Their
/// conditions and actions refer to the player, which must outlive its machine.
class SoccerOptions {
 public:
  explicit SoccerOptions(SoccerMind& player) : player_(player), machine_(player.machine_) {}
  void build();

 private:
  using Option = OptionMachine::Option;
  using Head = Intention::Head;

  // The game.
  void buildGame(Option& game, Option& playing, Option& place) const;
  void buildPlaying(Option& playing, Option& strike, Option& keepGoal, Option& place) const;
  // Roles.
  void buildKeepGoal(Option& keepGoal, Option& strike, Option& place) const;
  void buildStrike(Option& strike, Option& search) const;
  /// The states of `strike` in which the ball is at the paws.
  void buildAtBall(Option& strike) const;
  // Skills.
  void buildPlace(Option& place) const;
  void buildSearch(Option& search) const;

  OptionMachine::Action stands(Head head) const;
  /// Time in the present state is more than a parameter, which may change meanwhile.
  OptionMachine::Condition after(double SoccerMind::Options::*limit) const;
  OptionMachine::Condition isLost() const;

  SoccerMind& player_;
  OptionMachine& machine_;
};

}  // namespace modules
