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

// Where the resources keep what belongs to a kind of robot or to a field.

/// resources/robots/<kind>.yaml
std::filesystem::path descriptionFile(const std::string& kind);
/// The process layout that such robots have unless a person chooses another one.
std::filesystem::path layoutFile(const robotlink::RobotDescription& robot);
/// The folder of the parameters of its solutions.
std::filesystem::path parameterFolder(const robotlink::RobotDescription& robot);
/// resources/fields/<name>.yaml; empty where there is no name.
std::filesystem::path fieldFile(const std::string& name);

tl::expected<std::shared_ptr<const robotlink::RobotDescription>, robotlink::Errors> readRobot(
    const std::string& kind);
tl::expected<robotlink::RobotUse, robotlink::Errors> readUse(const std::string& kind);
/// Without a file a field that has nothing: no goals, no lines, no colors.
tl::expected<std::shared_ptr<const robotlink::FieldDescription>, robotlink::Errors> readField(
    const std::filesystem::path& file);

}  // namespace app
