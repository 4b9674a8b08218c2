// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "modules/modeling/PlayerTracker.h"

namespace modules {

/// Robots of one's own team report where they are. Replaces the players of `team` that were seen near
/// reported places, which are meters in the field, by these places; players seen elsewhere stay,
/// since a robot may have lost its way, or have no program that says anything.
std::vector<TrackedPlayer> withReportedMates(std::vector<TrackedPlayer> seen, const std::string& team,
                                             std::span<const robotlink::Vector2> reported);

}  // namespace modules
