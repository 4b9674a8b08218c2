// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/platforms/simulated/game/FoulWatch.h"
#include "app/platforms/simulated/game/GameMachine.h"
#include "app/platforms/simulated/game/GamePlacing.h"
#include "app/platforms/simulated/game/GamePlayers.h"
#include "app/platforms/simulated/game/Umpire.h"
#include "robotlink/config/FieldDescription.h"

namespace robotcontrol {
class ControlGame;
}

namespace app {

/// The referee of a simulated game, by rules that are data: phases, clock, score, kick-off with automatic
/// placing, balls that are out or stuck, and penalties. It decides by itself, or does only what is requested.
///
/// The simulation must outlive it. Its actions follow from the state of the simulation and from the
/// requests; it is part of snapshots. Used in the simulation's thread.
class Referee final : public Umpire {
 public:
  /// A penalty that a robot is serving.
  struct Penalized {
    const GameRules::Penalty* penalty = nullptr;
    robotlink::Duration left{};
  };

  /// The record of a player since the game began.
  struct Tally {
    unsigned penalties = 0;
    /// The longest time it was outside of the field without being penalized, and how long it lay.
    robotlink::Duration longestOutside{}, fallen{};
  };

  /// Returns null if the scene has no field, no ball, or no robot of the teams.
  static std::unique_ptr<Referee> create(std::shared_ptr<const GameRules> rules,
                                         std::shared_ptr<const robotlink::FieldDescription> field,
                                         simcore::Simulation& simulation);

  std::vector<std::string> step() override;
  void restart() override;
  /// Restores the state at the start, in which the referee also decides by itself.
  void startOver() {
    isAutomatic_ = true;
    restart();
  }
  void transfer(simcore::StateStream& stream) override;
  void worldJumped() override;
  /// Robots that are new play from now on.
  bool followModels() override;
  const std::map<std::string, int>& goals() const override { return goals_; }

  /// Fulfills a request, but for the radio. Fails with the reason, changing nothing.
  robotlink::Result<void> control(const robotcontrol::ControlGame& wanted);

  const GameRules& rules() const { return *rules_; }
  const robotlink::FieldDescription& field() const { return *field_; }
  const GameMachine& machine() const { return machine_; }
  bool isAutomatic() const { return isAutomatic_; }
  const std::vector<GamePlayer>& players() const { return players_; }
  /// An entry for each player, by its index.
  const std::optional<Penalized>& penaltyOf(std::size_t player) const { return penalized_[player]; }
  const Tally& tallyOf(std::size_t player) const { return tallies_[player]; }
  /// The last thing that happened, as a sentence.
  const std::string& message() const { return message_; }
  /// Grows with everything that happens.
  std::uint64_t changes() const { return changes_; }

 private:
  Referee(std::shared_ptr<const GameRules> rules, std::shared_ptr<const robotlink::FieldDescription> field,
          simcore::Simulation& simulation);
  /// The robots and the ball that there are.
  void findPlayers();
  void say(std::string text);
  robotlink::Result<void> enter(GameMachine::Phase phase);
  void followPhases();
  /// The robots and the ball go to where they belong at a kick-off.
  void beginPlacing();
  /// Puts those that have not found room yet.
  void continuePlacing();
  /// Puts those back that have left their places before the game continued.
  void correctPlaces();
  bool kicks(const GamePlayer& player) const { return player.team == machine_.kickOff(); }
  int directionOf(const GamePlayer& player) const { return machine_.direction(player.team); }
  robotlink::Result<std::size_t> playerNamed(const std::string& robot) const;
  robotlink::Result<std::size_t> teamNamed(const std::string& team) const;
  // Requests by name.
  robotlink::Result<void> penalizeFor(const std::string& robot, const std::string& reason);
  robotlink::Result<void> bringBack(const std::string& robot);
  robotlink::Result<void> setScore(const std::string& team, unsigned goals);
  robotlink::Result<void> giveKickOff(const std::string& team);
  std::optional<robotlink::Vector3> ballPlace() const;
  void watchBall();
  void noteGoal(std::size_t team);
  void dropBall(const robotlink::Vector2& from);
  void watchFouls();
  /// Counts how long robots are outside and lie.
  void tally();
  void penalize(std::size_t player, const GameRules::Penalty& penalty);
  /// False if there is no room for it.
  bool returnPlayer(std::size_t player);
  void passPenalties();
  void noteGoals();

  std::shared_ptr<const GameRules> rules_;
  std::shared_ptr<const robotlink::FieldDescription> field_;
  simcore::Simulation& simulation_;
  GameMachine machine_;
  FoulWatch fouls_;
  GamePlacing placing_;
  bool isAutomatic_ = true;
  std::string ball_;
  std::vector<GamePlayer> players_;
  /// An entry for each player, by its index.
  std::vector<std::optional<Penalized>> penalized_;
  std::vector<Tally> tallies_;
  /// For how long each has been outside now.
  std::vector<robotlink::Duration> outside_;
  std::vector<bool> toPlace_;
  bool ballToPlace_ = false;
  robotlink::Duration untilFouls_{}, outFor_{}, stuckFor_{};
  robotlink::Vector2 stuckPlace_ = robotlink::Vector2::Zero();
  std::map<std::string, int> goals_;
  std::vector<std::string> texts_;
  std::string message_;
  std::uint64_t changes_ = 0;
};

}  // namespace app
