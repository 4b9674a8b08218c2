// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"

namespace robotlink {

/// The field and the teams of a kind of robot, from resources/robots/<name>.yaml. Code that puts a robot on a
/// platform takes it from here and passes it to the robot's program. A plain value.
struct RobotUse {
  /// The field (resources/fields/<name>.yaml) that its program knows where neither scene nor log name one;
  /// empty: none.
  std::string field;
  /// The teams that such robots play in; empty: none.
  std::vector<std::string> teams;

  /// The default team of a robot of this name: the one with which its name begins, otherwise the first one.
  /// Empty if such robots play in none.
  std::string teamOf(const std::string& robot) const;
};

/// From the same file and text as the robot's description, which has the other keys.
tl::expected<RobotUse, Errors> readRobotUse(const std::filesystem::path& file);
tl::expected<RobotUse, Errors> parseRobotUse(const std::string& text, const std::string& file);

}  // namespace robotlink
