// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "app/platforms/simulated/game/GameRules.h"

namespace simcore {
class StateStream;
}

namespace app {

/// The phases of a game, its clock and its score, apart from any world. Teams are indices into
/// GameRules::teams. Time is what passes in pass(), so the game continues whatever clocks do.
class GameMachine {
 public:
  /// The phases of a game, as in robotcontrol::GameState::Phase.
  enum class Phase : std::uint8_t { kInitial, kReady, kSet, kPlaying, kFinished };

  /// The rules must outlive it.
  explicit GameMachine(const GameRules& rules) : rules_(rules) {}

  /// The game starts over.
  void restart();
  void pass(robotlink::Duration time);
  /// The phase that follows now unless the referee decides otherwise; unset: the current one lasts.
  std::optional<Phase> due() const;
  /// Begins a phase; READY after a half begins the next one. Fails with the reason where that is against the
  /// order of phases.
  robotlink::Result<void> enter(Phase phase);
  /// A goal for a team; the other one has the kick-off then.
  void score(std::size_t team);
  void setGoals(std::size_t team, unsigned goals) { goals_[team] = goals; }
  void setKickOff(std::size_t team) { kickOff_ = team; }

  Phase phase() const { return phase_; }
  /// Whether this was the last half.
  bool isOver() const { return phase_ == Phase::kFinished && half_ >= rules_.halves; }
  /// From 1.
  unsigned half() const { return half_; }
  /// The remaining time of the half, not below 0.
  robotlink::Duration left() const;
  std::size_t kickOff() const { return kickOff_; }
  unsigned goals(std::size_t team) const { return goals_[team]; }
  /// 1 if the team plays toward +x, otherwise -1.
  int direction(std::size_t team) const;
  /// The team that plays toward that side, 1 or -1.
  std::size_t attackerOf(int side) const { return direction(0) == side ? 0 : 1; }

  void transfer(simcore::StateStream& stream);

 private:
  const GameRules& rules_;
  Phase phase_ = Phase::kInitial;
  unsigned half_ = 1;
  /// Since the phase, and since the half began.
  robotlink::Duration ofPhase_{}, ofHalf_{};
  std::size_t kickOff_ = 0;
  std::array<unsigned, 2> goals_{};
};

}  // namespace app
