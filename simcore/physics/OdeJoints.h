// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "simcore/physics/OdeWorld.h"

namespace simcore {

/// Creates a joint of a model whose bodies exist, at their poses with all joints at 0. Wheels of drives have
/// none.
void addJoint(OdeWorld& ode, const ModelInstance& model, const JointDescription& joint,
              std::size_t firstBody);

/// Before each step: makes passive joints resist. Viscous resistance is a motor that brakes with at most
/// damping times the present speed, which is stable for any step, unlike a torque computed from the speed.
void resist(OdeWorld& ode);

}  // namespace simcore
