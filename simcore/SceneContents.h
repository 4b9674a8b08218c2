// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "robotlink/base/GroundMap.h"
#include "simcore/world/RenderScene.h"
#include "simcore/world/SceneRobots.h"
#include "simcore/world/WorldDescription.h"

namespace simcore {

/// What a Scene holds; for this folder's sources and tests only.
struct SceneContents {
  std::filesystem::path file;
  std::vector<SceneRobot> robots;
  std::vector<std::string> balls;
  std::string field;
  WorldDescription world;
  std::shared_ptr<const RenderScene> renderScene;
  std::shared_ptr<const robotlink::GroundMap> groundMap;  ///< null: the world comes from no map
};

}  // namespace simcore
