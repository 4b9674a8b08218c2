// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"

namespace robotlink {
struct RobotDescription;
}

namespace app {

// The scenes, layouts and robots that the workbench offers, as they are in the resources.

/// The shipped scenes and maps.
std::vector<std::filesystem::path> shippedScenes();
/// A shipped scene by its name ("field2002"), or any other by its path.
std::filesystem::path sceneNamed(const std::string& name);

/// Replaces the name of a shipped scene by its file. Fails if there is no file and no scene of this name,
/// with those that there are; an invalid path is reported when it is read.
robotlink::Result<void> findScene(std::filesystem::path& scene);

/// The shipped layouts.
std::vector<std::filesystem::path> shippedLayouts();
/// A shipped layout by its name ("compact"), or any other by its path.
std::filesystem::path layoutNamed(const std::string& name);
/// The shipped layouts that can be run by a kind of robot.
std::vector<std::filesystem::path> layoutsFor(const robotlink::RobotDescription& robot);

/// A kind of robot that can be added to a simulated world, since it has a description and a model.
struct RobotKind {
  /// "p3at"
  std::string name;
  /// "Pioneer 3-AT"
  std::string title;
  /// The teams that such robots play in; empty: none.
  std::vector<std::string> teams;
};
/// All of these kinds, sorted by name.
std::vector<RobotKind> simulatedRobots();
/// The teams of all of these kinds, each once.
std::vector<std::string> simulatedTeams();
/// The teams of this name: that team, or all of simulatedTeams() for any other name.
std::vector<std::string> teamsNamed(const std::string& name);

}  // namespace app
