// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/config/RobotUse.h"

#include <algorithm>

namespace robotlink {

std::string RobotUse::teamOf(const std::string& robot) const {
  const auto found =
      std::find_if(teams.begin(), teams.end(), [&](const auto& team) { return robot.starts_with(team); });
  if (found != teams.end()) return *found;
  return teams.empty() ? std::string() : teams.front();
}

}  // namespace robotlink
