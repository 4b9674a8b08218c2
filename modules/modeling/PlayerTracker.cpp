// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/modeling/PlayerTracker.h"

#include <algorithm>
#include <cmath>

namespace modules {

void PlayerTracker::update(double time, std::span<const TrackedPlayer> seen) {
  const double decay = std::exp2(-std::max(0.0, time - updatedAt_) / options_.halfLife);
  updatedAt_ = time;
  for (TrackedPlayer& player : players_) player.confidence *= decay;

  for (const TrackedPlayer& percept : seen) {
    TrackedPlayer* nearest = nullptr;
    double distance = options_.sameWithin;
    for (TrackedPlayer& player : players_) {
      const double d = (player.positionInField - percept.positionInField).norm();
      if (player.team != percept.team || d > distance) continue;
      distance = d;
      nearest = &player;
    }
    if (nearest == nullptr) {
      players_.push_back(percept);
      continue;
    }
    nearest->positionInField += options_.pull * (percept.positionInField - nearest->positionInField);
    nearest->confidence = 1 - (1 - nearest->confidence) * (1 - 0.5 * percept.confidence);
  }
  std::erase_if(players_,
                [this](const TrackedPlayer& player) { return player.confidence < options_.forgetBelow; });
  std::ranges::stable_sort(players_, std::ranges::greater(), &TrackedPlayer::confidence);
  if (players_.size() > options_.maximumPlayers) players_.resize(options_.maximumPlayers);
}

}  // namespace modules
