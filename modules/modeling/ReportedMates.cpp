// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/modeling/ReportedMates.h"

#include <algorithm>

namespace modules {
namespace {

/// The maximum distance between the place at which a robot was seen and the one that it reported, m.
constexpr double kSameRobot = 0.6;
constexpr double kReportedConfidence = 0.9;

}  // namespace

std::vector<TrackedPlayer> withReportedMates(std::vector<TrackedPlayer> seen, const std::string& team,
                                             std::span<const robotlink::Vector2> reported) {
  std::erase_if(seen, [&](const TrackedPlayer& player) {
    return player.team == team && std::ranges::any_of(reported, [&](const robotlink::Vector2& place) {
             return (place - player.positionInField).norm() < kSameRobot;
           });
  });
  for (const robotlink::Vector2& place : reported) seen.push_back({team, place, kReportedConfidence});
  return seen;
}

}  // namespace modules
