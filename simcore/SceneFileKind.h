// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/base/FileSuffix.h"

namespace simcore {

// Determines the kind of a file by its name, ignoring case. The file need not exist.

/// Whether a scene is the map of a building's floor: *.map.
inline bool isMapFile(const std::filesystem::path& file) {
  return robotlink::fileSuffix(file) == ".map";
}

/// Whether a file is a scene: a world or a model (*.sdf, *.world, *.xml, *.urdf) or a map.
inline bool isSceneFile(const std::filesystem::path& file) {
  const std::string suffix = robotlink::fileSuffix(file);
  return suffix == ".sdf" || suffix == ".world" || suffix == ".xml" || suffix == ".urdf" || suffix == ".map";
}

}  // namespace simcore
