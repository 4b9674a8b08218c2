// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/base/Error.h"
#include "robotlink/base/GroundMap.h"
#include "simcore/world/WorldDescription.h"

namespace simcore {

/// Builds a world from a map: a floor, and the map's lines and points as walls 1 m high, all in one static
/// model "walls". The world's frame is the map's. Fails if the map is too large to be simulated. `file` is
/// the name that errors carry.
robotlink::Result<WorldDescription> mapWorld(const robotlink::GroundMap& map, const std::string& file);

}  // namespace simcore
