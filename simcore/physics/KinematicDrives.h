// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simcore/physics/OdeWorld.h"

namespace simcore {

/// Moves all kinematic models on by one step, in order: each as its rims' speeds and its track say, in the
/// plane. A move that would let it sink into something, or deeper than it does, is not made: it stays, its
/// wheels are blocked, and what it touches is noted. Where nothing is near, no solids are compared.
void moveKinematicModels(OdeWorld& ode);

}  // namespace simcore
