// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simcore/physics/OdeWorld.h"

namespace simcore {

/// Advances all kinematic models by one step, in their order, in the plane, by the speeds of their rims and
/// their track. A move that would make a model overlap something, or overlap it deeper, is not made: the
/// model stops in front of it, its wheels are blocked, and the contact is recorded. Where nothing is near, no
/// solids are compared. A model that was placed in the air is lowered to what is below it.
void moveKinematicModels(OdeWorld& ode);

}  // namespace simcore
