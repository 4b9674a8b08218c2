// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "simcore/world/RenderScene.h"
#include "simcore/world/WorldDescription.h"

namespace simcore {

/// Builds what is drawn of a world. Body 0 is the world with all static models, followed by the links of all
/// other models in order, named "red1/head". Equal shapes share a mesh.
std::shared_ptr<const RenderScene> buildRenderScene(const WorldDescription& world);

}  // namespace simcore
