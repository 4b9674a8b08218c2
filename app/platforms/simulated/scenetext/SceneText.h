// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"

namespace app {

// Functions for the scene editor that need the simulator: checking texts, listing models. All may be called
// from any thread; those that load a scene take some 100 ms, for large ones seconds.

/// A finding about the text of a scene.
struct SceneTextFinding {
  /// Otherwise it is an error, because of which the scene cannot be opened.
  bool isWarning = false;
  robotlink::Error error;
};

/// Folders in which models are searched first, as for simcore::Scene::load().
using ModelFolders = std::vector<std::filesystem::path>;

/// Checks a text as if it were in a file, which need not exist: a world, a model alone, or a map (by the
/// file's suffix). Files that it includes are read from the disk, as the world in `file` would find them;
/// their errors are among the findings, with their files. What can be opened, but not as it is described
/// (simcore::Scene::leftOut()), gives warnings.
std::vector<SceneTextFinding> checkSceneText(const std::string& text, const std::filesystem::path& file,
                                             const ModelFolders& folders = {});

/// A model that a world can include.
struct SceneModelFile {
  std::string name;
  /// The URI with which an <include> names it: "model://p3at".
  std::string uri;
  std::filesystem::path file;
  bool isRobot = false;
};

/// The models that a world in this file finds by their names, in all folders in which models are searched
/// (simcore/sdf/ModelSearch.h). By name; of those with the same name the one that would be taken.
std::vector<SceneModelFile> sceneModels(const std::filesystem::path& file, const ModelFolders& folders = {});

/// The file that a URI in a scene's file means; nothing if there is none.
std::optional<std::filesystem::path> sceneModelFile(const std::string& uri, const std::filesystem::path& file,
                                                    const ModelFolders& folders = {});

/// The properties of a new room. Lengths in m.
struct NewRoom {
  /// The world's name: letters, digits, '-' and '_'.
  std::string name = "room";
  double width = 6, depth = 4, wallHeight = 1;
  /// Whether a wall across the middle has an opening of 1 m.
  bool doorway = false;
  /// The name of a model that is a robot; empty: none.
  std::string robot = {};
};

/// The text of a new world from the shipped template, which can be opened as it is. Fails if a value makes no
/// sense, or if there is no such robot. `file`: where it will be, for finding the robot.
robotlink::Result<std::string> newRoomText(const NewRoom& room, const std::filesystem::path& file,
                                           const ModelFolders& folders = {});

/// The elements of a new object for a world in `file`, which stands on the ground at x and y (m): a box, ball
/// or cylinder that moves, a lamp, a camera, or a model by its name. Robots stand on their feet or wheels,
/// other models have z = 0. `name` must be free.
robotlink::Result<std::string> newObjectText(const std::string& kind, const std::string& name, double x,
                                             double y, const std::filesystem::path& file,
                                             const ModelFolders& folders = {});

}  // namespace app
