// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "robotlink/base/GroundMap.h"
#include "simcore/world/LeftOut.h"
#include "simcore/world/Palette.h"
#include "simcore/world/RenderScene.h"
#include "simcore/world/SceneRobots.h"
#include "simcore/world/WorldDescription.h"

namespace simcore {

/// The contents of a Scene, for the sources and tests of this folder only.
struct SceneContents {
  std::filesystem::path file;
  /// The model folders that were passed to load().
  std::vector<std::filesystem::path> modelFolders;
  /// The colors of the scene and of all its models.
  Palette palette;
  std::vector<SceneRobot> robots;
  std::vector<std::string> balls;
  // The results of Scene::balls() and Scene::field().
  std::string field;
  WorldDescription world;
  /// Shared by all simulations and viewers of the scene.
  std::shared_ptr<const RenderScene> renderScene;
  LeftOuts leftOut;
  /// Null if the file is not a map.
  std::shared_ptr<const robotlink::GroundMap> groundMap;

  /// Sets what follows from the world: robots, balls, field, renderScene.
  void complete();
};

}  // namespace simcore
