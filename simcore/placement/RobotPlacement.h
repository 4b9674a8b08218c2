// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/base/Error.h"
#include "robotlink/base/GroundMap.h"
#include "simcore/world/Palette.h"
#include "simcore/world/SceneRobots.h"
#include "simcore/world/WorldDescription.h"

namespace simcore {

/// Puts robots of a type into a world, as described for Scene::load(). `map` is the one from which the world
/// was built, or null. `palette` contains the teams' colors. `file` is the scene's, for error messages.
robotlink::Result<void> addRobots(WorldDescription& world, const robotlink::GroundMap* map,
                                  const std::shared_ptr<const ModelDescription>& type,
                                  const RobotsToAdd& robots, const Palette& palette, const std::string& file);

/// Whether a part of such models has the color of their team.
bool wearsTeamColor(const ModelDescription& type);

}  // namespace simcore
