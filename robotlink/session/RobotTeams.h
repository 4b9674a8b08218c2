// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robotlink/session/Session.h"

// The teams of the robots of a session. Only in the thread that ticks the session.
namespace robotlink {

/// The team of a robot as the scene says, empty if it has none; unset: not known, as in old logs.
std::optional<std::string> teamOf(const StreamStore& store, const std::string& robot, Instant shown);
/// The teams of the session's robots now, each once, in the order of the robots.
std::vector<std::string> teamNames(Session& session);
/// The names of the session's robots now, and behind them those of their teams.
std::vector<std::string> robotAndTeamNames(Session& session);
/// The robots of a team now, in the order of the session's.
std::vector<std::string> robotsOfTeam(Session& session, const std::string& team);
/// Returns the robots that a name denotes now: the robot of this name, or else all of that team. Empty: there
/// are none.
std::vector<std::string> robotsNamed(Session& session, const std::string& name);

}  // namespace robotlink
