// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simcore/physics/OdeWorld.h"

namespace simcore {

/// Creates the drive of a model: its sides, wheels, and their solids. The bodies of all other links must
/// exist.
void addDrive(OdeWorld& ode, const ModelInstance& model, int index);

/// Adds a wheel of a model to the side that was added last. Its axis is that of its joint.
void addWheel(OdeWorld& ode, const ModelDescription& type, const JointDescription& joint, int index,
              const OdeModel& added);

}  // namespace simcore
