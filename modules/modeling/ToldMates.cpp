// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/modeling/ToldMates.h"

#include <algorithm>

namespace modules {
namespace {

/// How far the place at which a robot was seen may be from the one that it told, m.
constexpr double kSameRobot = 0.6;
constexpr double kToldConfidence = 0.9;

}  // namespace

std::vector<TrackedPlayer> withToldMates(std::vector<TrackedPlayer> seen, const std::string& team,
                                         std::span<const robotlink::Vector2> told) {
  std::erase_if(seen, [&](const TrackedPlayer& player) {
    return player.team == team && std::ranges::any_of(told, [&](const robotlink::Vector2& place) {
             return (place - player.positionInField).norm() < kSameRobot;
           });
  });
  for (const robotlink::Vector2& place : told) seen.push_back({team, place, kToldConfidence});
  return seen;
}

}  // namespace modules
