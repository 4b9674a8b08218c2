// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ode/ode.h>

#include "simcore/WorldDescription.h"

namespace simcore {

/// The collision space for what does not move. A few solids are compared with everything that moves, one
/// after the other; many, as a building's walls, stand in a quadtree, or a robot would be compared with each
/// of thousands in every step.
dSpaceID newStaticSpace(const WorldDescription& world, dSpaceID parent);

}  // namespace simcore
