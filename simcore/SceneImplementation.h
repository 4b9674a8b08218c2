// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/base/GroundMap.h"
#include "simcore/RenderScene.h"
#include "simcore/Scene.h"
#include "simcore/WorldDescription.h"

namespace simcore {

/// What a Scene holds; for this folder's sources and tests only.
struct Scene::Implementation {
  std::filesystem::path file;
  std::vector<Robot> robots;
  std::vector<std::string> balls;
  std::string field;
  WorldDescription world;
  std::shared_ptr<const RenderScene> renderScene;
  std::shared_ptr<const robotlink::GroundMap> groundMap;  ///< null: the world comes from no map
};

}  // namespace simcore
