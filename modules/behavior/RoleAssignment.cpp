// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/behavior/RoleAssignment.h"

#include <tuple>

namespace modules {

bool RoleAssignment::isGoalie(const GameSituation& now) {
  if (now.givenRole != Role::kNone) return now.givenRole == Role::kGoalie;
  if (now.number != 1) return false;
  if (!now.mates.empty()) heardAt_ = now.time;
  // Alone, it has to score.
  if (now.mates.empty()) return role_ == Role::kGoalie && now.time - heardAt_ < options_.lonelyAfter;
  for (const Mate& mate : now.mates)
    if (mate.number != 1 && mate.role == Role::kGoalie && role_ != Role::kGoalie) return false;
  return true;
}

Role RoleAssignment::decide(const GameSituation& now, double secondsToBall) {
  if (isGoalie(now)) return role_ = Role::kGoalie;
  if (now.givenRole != Role::kNone) return role_ = now.givenRole;
  using Bid = std::tuple<double, int>;
  const Bid mine(secondsToBall - (role_ == Role::kStriker ? options_.strikerAdvantage : 0), now.number);
  bool first = true, last = true;
  const double myDepth =
      (now.pose ? now.pose->x : 0) - (role_ == Role::kDefender ? options_.defenderAdvantage : 0);
  // The striker of the others, whose place is not compared.
  const Mate* striker = nullptr;
  Bid best = mine;
  for (const Mate& mate : now.mates) {
    if (mate.role == Role::kGoalie) continue;
    const Bid bid(mate.secondsToBall - (mate.role == Role::kStriker ? options_.strikerAdvantage : 0),
                  mate.number);
    if (bid < best) {
      best = bid;
      striker = &mate;
      first = false;
    }
  }
  if (first) return role_ = Role::kStriker;
  for (const Mate& mate : now.mates) {
    if (mate.role == Role::kGoalie || &mate == striker) continue;
    const double depth = mate.pose.x - (mate.role == Role::kDefender ? options_.defenderAdvantage : 0);
    if (std::tuple(depth, mate.number) < std::tuple(myDepth, now.number)) last = false;
  }
  return role_ = last ? Role::kDefender : Role::kSupporter;
}

}  // namespace modules
