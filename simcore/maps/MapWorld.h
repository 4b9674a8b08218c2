// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/base/Error.h"
#include "robotlink/base/GroundMap.h"
#include "simcore/world/WorldDescription.h"

namespace simcore {

/// A map as a world: a floor, and its lines and points as walls of 1 m height, all of them one static model
/// "walls". The world's frame is the map's. Fails if there is more to it than can be simulated.
robotlink::Result<WorldDescription> mapWorld(const robotlink::GroundMap& map, const std::string& file);

}  // namespace simcore
