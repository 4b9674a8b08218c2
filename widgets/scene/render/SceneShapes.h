// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/scene/render/SceneMesh.h"

namespace foxglove {
class SceneEntity;
}

namespace widgets {

/// Converts an entity. Spheres, cubes, cylinders and arrows become triangles; triangles get normals, smooth
/// where neighbors meet at an angle below 40 degrees. Invalid parts (an index past the end) are left out.
/// Pure.
SceneShape shapeOf(const foxglove::SceneEntity& entity);

}  // namespace widgets
