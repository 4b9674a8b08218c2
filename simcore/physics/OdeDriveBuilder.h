// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simcore/physics/OdeWorld.h"

namespace simcore {

/// Creates the drive of a model: its sides, wheels, and their solids. The bodies of all other links must
/// exist.
void addDrive(OdeWorld& ode, const ModelInstance& model, int index);

}  // namespace simcore
