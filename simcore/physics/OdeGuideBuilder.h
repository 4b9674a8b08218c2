// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simcore/physics/OdeWorld.h"

namespace simcore {

/// Adds the motors by which a guided model is pushed, which do nothing yet, to a model whose bodies stand
/// where they start. A flying model has no weight from now on; a walking one stays upright, at its height,
/// and as stiff as it starts.
void addGuide(OdeWorld& ode, const GuidedMotion& motion, OdeModel& model);

}  // namespace simcore
