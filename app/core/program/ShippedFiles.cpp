// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/program/ShippedFiles.h"

#include <algorithm>

#include "robotlink/base/FileSuffix.h"
#include "robotlink/base/Resources.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/config/RobotUse.h"
#include "robotlink/debugging/RegisteredTasks.h"
#include "robotlink/debugging/program/RobotProgram.h"
#include "robotlink/process/Layout.h"

namespace app {
namespace {

/// The files with an extension in a folder of the resources, sorted.
std::vector<std::filesystem::path> filesIn(const char* folder, const char* extension) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(robotlink::resource(folder), error)) {
    if (robotlink::fileSuffix(entry.path()) == extension) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

/// Returns a shipped file by its name without extension ("compact"), or else the name as a path.
std::filesystem::path shippedOr(const std::vector<std::filesystem::path>& shipped, const std::string& name) {
  for (const auto& file : shipped) {
    if (file.stem() == name) return file;
  }
  return name;
}

}  // namespace

std::vector<std::filesystem::path> shippedScenes() {
  std::vector<std::filesystem::path> files = filesIn("scenes", ".sdf");
  const auto maps = filesIn("scenes", ".map");
  files.insert(files.end(), maps.begin(), maps.end());
  return files;
}

std::filesystem::path sceneNamed(const std::string& name) {
  return shippedOr(shippedScenes(), name);
}

robotlink::Result<void> findScene(std::filesystem::path& scene) {
  const std::string name = scene.string();
  scene = sceneNamed(name);
  std::error_code ignored;
  if (scene.has_extension() || scene.has_parent_path() || std::filesystem::exists(scene, ignored)) return {};
  std::string shipped;
  for (const auto& file : shippedScenes()) shipped += (shipped.empty() ? "" : ", ") + file.stem().string();
  return robotlink::failure(
      "sim.scene", "there is no scene '" + name + "': give a file, or one of " + shipped, {}, {name});
}

std::vector<std::filesystem::path> shippedLayouts() {
  return filesIn("layouts", ".yaml");
}

std::filesystem::path layoutNamed(const std::string& name) {
  return shippedOr(shippedLayouts(), name);
}

std::vector<std::filesystem::path> layoutsFor(const robotlink::RobotDescription& robot) {
  const robotlink::TaskCatalog catalog = robotlink::registeredTasks();
  const robotlink::PlatformPackages platform{robot.offers, robot.takes, robotlink::debugPackages()};
  std::vector<std::filesystem::path> fitting = shippedLayouts();
  std::erase_if(fitting, [&](const std::filesystem::path& file) {
    const auto layout = robotlink::readLayout(file);
    return !layout || !robotlink::checkLayout(*layout, catalog, platform).empty();
  });
  return fitting;
}

std::vector<RobotKind> simulatedRobots() {
  std::vector<RobotKind> kinds;
  for (const auto& file : filesIn("robots", ".yaml")) {
    const std::string name = file.stem().string();
    std::error_code error;
    if (!std::filesystem::exists(robotlink::resource("scenes/models/" + name + "/model.sdf"), error))
      continue;
    const auto description = robotlink::readRobotDescription(file);
    const auto use = robotlink::readRobotUse(file);
    if (description && use) kinds.push_back({name, description->title, use->teams});
  }
  return kinds;
}

std::vector<std::string> simulatedTeams() {
  std::vector<std::string> teams;
  for (const RobotKind& kind : simulatedRobots()) {
    for (const std::string& team : kind.teams) {
      if (std::ranges::find(teams, team) == teams.end()) teams.push_back(team);
    }
  }
  return teams;
}

std::vector<std::string> teamsNamed(const std::string& name) {
  std::vector<std::string> teams = simulatedTeams();
  if (std::ranges::find(teams, name) != teams.end()) return {name};
  return teams;
}

}  // namespace app
