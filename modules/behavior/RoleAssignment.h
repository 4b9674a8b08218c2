// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/behavior/GameSituation.h"

namespace modules {

/// Gives a player its role from what it knows of its team. Each player decides for itself, by the same rules
/// and messages, so that they agree as far as messages arrive: the goalkeeper is number 1 of several, or whom
/// the scene says; the field player that has the ball first is the striker, who keeps the role until another
/// one is clearly faster; of the others the one next to the own goal is the defender, the rest support.
///
/// After D. Vail and M. Veloso, "Dynamic multi-robot coordination" (2003), with estimated times as the bids.
/// Not thread-safe.
class RoleAssignment {
 public:
  struct Options {
    /// The time by which a player has to be faster to take over the striker's role, s.
    double strikerAdvantage = 2;
    /// The distance by which it has to be nearer to the own goal to take over the defender's, m.
    double defenderAdvantage = 0.3;
    /// The time that the goalie stays in its goal without hearing of others, s.
    double lonelyAfter = 30;
  };
  explicit RoleAssignment(const Options& options) : options_(options) {}
  void setOptions(const Options& options) { options_ = options; }

  /// Call it once a frame; `secondsToBall` is the player's own estimate.
  Role decide(const GameSituation& now, double secondsToBall);
  Role role() const { return role_; }

 private:
  bool isGoalie(const GameSituation& now);

  Options options_;
  Role role_ = Role::kNone;
  /// The time at which it last heard of others, s.
  double heardAt_ = 0;
};

}  // namespace modules
