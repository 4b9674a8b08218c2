// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

namespace simcore {
class StateStream;
}

namespace app {

/// Watches a simulated game and acts in its world: a Referee where the scene names rules, otherwise a
/// KickOff. Decisions depend on the state of the simulation and on requests only, so a run stays
/// reproducible. Used in the simulation's thread.
class Umpire {
 public:
  virtual ~Umpire() = default;

  /// Call this after each step of the world. Returns a sentence for the user for each thing that happened.
  virtual std::vector<std::string> step() = 0;
  /// Call this after a reset of the simulation: the game starts over.
  virtual void restart() = 0;
  /// Writes or reads all that the game consists of.
  virtual void transfer(simcore::StateStream& stream) = 0;
  /// Call this when the simulation jumped to another instant; the game continues as it is.
  virtual void worldJumped() = 0;
  /// Call this when there are other models. Returns false if there is no longer a game.
  virtual bool followModels() = 0;
  /// Goals by the name of the team that scored.
  virtual const std::map<std::string, int>& goals() const = 0;
};

}  // namespace app
