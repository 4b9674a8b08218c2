// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simcore/physics/OdeWorld.h"

namespace simcore {

/// From this number of contacts on, a body stands, and does not roll.
constexpr int kStands = 3;

/// Notes a body among OdeWorld::freeBodies if no joint holds it, or if its model may sleep. All joints must
/// exist.
void addFreeBody(OdeWorld& ode, dBodyID body, bool maySleep);

/// Before a step: exerts the gyroscopic torque on bodies that wobble, and notes where all of them stand.
///
/// ODE's own (implicit Euler) is stable for any speed, but takes the wobble out of a spinning top. Here the
/// angular velocity w of a step is that in its middle, from the angular momentum L, which then is constant:
/// R I R^T w = exp(-h w / 2) L, with the attitude R before the step. This is symmetric in time, so that
/// energy does not drift. Bodies that turn so fast that the equation cannot be solved are left to ODE.
void prepareFreeBodies(OdeWorld& ode);

/// Counts the contacts of a body in this step; it may be null.
void countContact(dBodyID body);

/// After a step: keeps bodies in place that stand on at least three points and hardly move. Small errors of
/// the solver would let them creep, by millimeters a minute. A rolling body has fewer points, and a sliding
/// one gains more speed in a step unless it is within 2 % of the limit of friction.
void letFreeBodiesRest(OdeWorld& ode);

}  // namespace simcore
