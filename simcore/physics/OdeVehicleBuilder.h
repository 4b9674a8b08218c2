// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simcore/physics/OdeWorld.h"

namespace simcore {

/// Adds the wheels of a vehicle, each a side of its own; the bodies that carry them exist.
void addVehicle(OdeWorld& ode, const ModelInstance& model, int index);

}  // namespace simcore
