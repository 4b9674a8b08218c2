// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simcore/physics/OdeWorld.h"

namespace simcore {

/// How far a ray gets until it meets a solid of another model than its own, at most `length`, m.
double castRay(OdeWorld& ode, const Vector3& origin, const Vector3& direction, double length, int ownModel);

/// How far a moving model, as it stands, is above what is below the middles of its solids, m; kGroundDepth if
/// that is nothing.
double gapBelow(OdeWorld& ode, int model);
/// In m: how far below a model the ground is searched.
inline constexpr double kGroundDepth = 1000;

/// Lowers a moving model, as it stands, onto what is below it, unless that is less than 1 mm away or there is
/// nothing. On a slope it may stay a little above it. Where that would put it into an edge, it stays on the
/// edge.
void comeDown(OdeWorld& ode, int model);

}  // namespace simcore
