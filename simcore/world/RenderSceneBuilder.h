// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "simcore/world/RenderScene.h"
#include "simcore/world/WorldDescription.h"

namespace simcore {

/// What a world looks like. Body 0 is the world with all static models; then each link of each other model in
/// order, named "red1/head". Equal shapes share one mesh.
std::shared_ptr<const RenderScene> buildRenderScene(const WorldDescription& world);

}  // namespace simcore
