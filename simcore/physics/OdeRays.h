// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simcore/physics/OdeWorld.h"

namespace simcore {

/// How far a ray gets until it meets a solid of another model than its own, at most `length`, m.
double castRay(OdeWorld& ode, const Vector3& origin, const Vector3& direction, double length, int ownModel);

/// Lowers a moving model, as it stands, onto what is below it, unless that is less than 1 mm away or there is
/// nothing. On a slope it may stay a little above it.
void comeDown(OdeWorld& ode, int model);

}  // namespace simcore
