// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "robotlink/base/Error.h"

namespace robotlink {
struct FieldDescription;
struct RobotDescription;
struct RobotUse;
}  // namespace robotlink

namespace app {

// The resource files of a kind of robot ("p3at") or of a field ("2002"). The functions that return a path do
// not check whether the file exists; those that read fail with all errors, each with its position in the
// file.

/// Returns resources/robots/<kind>.yaml.
std::filesystem::path descriptionFile(const std::string& kind);
/// Returns the default process layout of such robots.
std::filesystem::path layoutFile(const robotlink::RobotDescription& robot);
/// Returns the folder of the parameter files of its solutions.
std::filesystem::path parameterFolder(const robotlink::RobotDescription& robot);
/// Returns the preset that belongs to a robot of this name, resources/presets/<name>.preset.json. Folders in
/// the name are ignored.
std::filesystem::path presetFile(const std::string& robot);
/// Returns resources/fields/<name>.yaml; an empty path for an empty name. Folders in the name are ignored.
std::filesystem::path fieldFile(const std::string& name);
/// Returns the shipped file of a field; empty if there is none. Reads all of the files.
std::filesystem::path fieldFileOf(const robotlink::FieldDescription& field);

/// Reads the description of a kind of robot.
tl::expected<std::shared_ptr<const robotlink::RobotDescription>, robotlink::Errors> readRobot(
    const std::string& kind);
/// Reads where such robots are used: their field and teams.
tl::expected<robotlink::RobotUse, robotlink::Errors> readUse(const std::string& kind);
/// Reads a field. For an empty path the result is a field without goals, lines and colors, not null.
tl::expected<std::shared_ptr<const robotlink::FieldDescription>, robotlink::Errors> readField(
    const std::filesystem::path& file);

}  // namespace app
