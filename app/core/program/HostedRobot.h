// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>

namespace robotlink {
struct FieldDescription;
struct GroundMap;
struct Preset;
struct RobotDescription;
}  // namespace robotlink

namespace app {

/// The identity of a robot: name, team, description and map, whether it is simulated, real or logged. A plain
/// value.
struct HostedRobot {
  /// A name such as "red1".
  std::string name;
  /// Empty if it plays in none.
  std::string team = {};
  /// Not null once a program was made for the robot.
  std::shared_ptr<const robotlink::RobotDescription> description = nullptr;
  /// Not null once a program was made; without a field, one that has no goals, lines and colors.
  std::shared_ptr<const robotlink::FieldDescription> field = nullptr;
  /// The map by which it drives; null if it has none.
  std::shared_ptr<const robotlink::GroundMap> map = nullptr;
  /// The file of `field`; empty if there is none.
  std::filesystem::path fieldFile = {};
  /// The file of `map`; empty if there is none.
  std::filesystem::path mapFile = {};
  /// The preset with which its first program starts, instead of what its layout and files say; null: none.
  std::shared_ptr<const robotlink::Preset> preset = nullptr;
  /// A preset that each of its programs starts with if it is another than before, and none was given; it need
  /// not exist. Empty: none.
  std::filesystem::path presetFile = {};
};

}  // namespace app
