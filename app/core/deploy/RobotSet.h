// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "robotlink/base/Error.h"

namespace app {

/// Robots that belong together, such as a team for a game: their addresses, and the files that each should
/// have. A plain value; ROBOT_SETS.md describes the file.
struct RobotSet {
  struct Robot {
    std::string name;
    /// For people; may be empty.
    std::string team = {}, role = {};
    /// ws://HOST:PORT, or wss://
    std::string address = {};
    /// A file: a layout, a color table; folders: parameters of one kind of robot, motions; a file: a preset.
    /// Relative to the folder of the set's file; empty: the robot keeps what it has.
    std::string layout = {}, colorTable = {}, parameters = {}, motions = {}, preset = {};
    bool operator==(const Robot&) const = default;
  };

  std::string name;
  std::vector<Robot> robots;
  bool operator==(const RobotSet&) const = default;
};

/// Reads a set. Fails with all errors, each with file and line: unknown keys, addresses that make no sense,
/// two robots of one name.
tl::expected<RobotSet, robotlink::Errors> parseRobotSet(std::string_view text, const std::string& file);
tl::expected<RobotSet, robotlink::Errors> readRobotSet(const std::filesystem::path& file);
/// The text that is read as the same.
std::string toText(const RobotSet& set);

}  // namespace app
