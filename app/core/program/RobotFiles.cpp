// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/program/RobotFiles.h"

#include "robotlink/base/Resources.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/config/RobotUse.h"

namespace app {

using robotlink::FieldDescription;
using robotlink::RobotDescription;

std::filesystem::path descriptionFile(const std::string& kind) {
  return robotlink::resource("robots/" + kind + ".yaml");
}

std::filesystem::path layoutFile(const RobotDescription& robot) {
  return robotlink::resource("layouts/" + robot.layout + ".yaml");
}

std::filesystem::path parameterFolder(const RobotDescription& robot) {
  return robotlink::resource("parameters/" + robot.name);
}

std::filesystem::path presetFile(const std::string& robot) {
  return robotlink::resource("presets/" + std::filesystem::path(robot).filename().string() + ".preset.json");
}

std::filesystem::path fieldFile(const std::string& name) {
  // Only the file name counts, so that a field cannot lead to another folder.
  if (name.empty()) return {};
  return robotlink::resource("fields/" + std::filesystem::path(name).filename().string() + ".yaml");
}

std::filesystem::path fieldFileOf(const FieldDescription& field) {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(robotlink::resource("fields"), ignored)) {
    const auto shipped = FieldDescription::load(entry.path());
    if (shipped && shipped->name == field.name) return entry.path();
  }
  return {};
}

tl::expected<std::shared_ptr<const RobotDescription>, robotlink::Errors> readRobot(const std::string& kind) {
  auto read = robotlink::readRobotDescription(descriptionFile(kind));
  if (!read) return tl::unexpected(read.error());
  return std::make_shared<const RobotDescription>(std::move(*read));
}

tl::expected<robotlink::RobotUse, robotlink::Errors> readUse(const std::string& kind) {
  return robotlink::readRobotUse(descriptionFile(kind));
}

tl::expected<std::shared_ptr<const FieldDescription>, robotlink::Errors> readField(
    const std::filesystem::path& file) {
  if (file.empty()) return std::make_shared<const FieldDescription>();
  auto read = FieldDescription::load(file);
  if (!read) return tl::unexpected(read.error());
  return std::make_shared<const FieldDescription>(std::move(*read));
}

}  // namespace app
