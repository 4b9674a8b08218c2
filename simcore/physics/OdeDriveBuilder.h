// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simcore/physics/OdeWorld.h"

namespace simcore {

/// Makes the drive of a model, whose bodies but the wheels stand in its place: sides, wheels, and their
/// solids.
void addDrive(OdeWorld& ode, const ModelInstance& model, int index);

}  // namespace simcore
