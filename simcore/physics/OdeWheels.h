// SPDX-License-Identifier: GPL-3.0-or-later
// Driven wheels in ODE; only for Physics and its parts.
//
// A wheel has no body of its own. Its mass is lumped into the body that carries it, and the contact itself
// drives: the tread moves with the wheel's speed along the rolling direction, with a force limited by the
// motors of its side. So a robot with four wheels is one body with four contacts instead of five bodies with
// four hinges, which costs a third and needs fewer iterations of the solver.
//
// Grip follows Coulomb's law: a sliding tire is pulled against its direction of sliding by friction times
// load. ODE's own friction limits the two directions separately; with it, wheels that turn on the spot would
// roll without sliding and scrub sideways, and the robot would turn as if its track were the distance of its
// wheels. Here the force in each direction is proportional to its share of the slip, with a factor computed
// from the slip of the last step (ODE's force-dependent slip, solved implicitly).
//
// The track of a skid-steered robot follows from this. Let its wheels be at (+-a, +-b), s the slip of their
// treads, and k the ratio of slip along to slip across at equal force. Turning on the spot at rate w, tires
// slide by w a across and by s along; the forces balance if s b = k w a^2, so the rims run at w b + s, and
// the track is 2 (b + k a^2 / b). k is chosen to give the model's track.
#pragma once

#include <ode/ode.h>

#include "simcore/physics/OdeWorld.h"

namespace simcore {

/// Whether a wheel touches something only with its flank (to ODE, a wheel is a sphere).
bool isFlank(const OdeWorld& ode, const OdeGeom& wheel, const dContactGeom& contact);
/// Adds the contact joint of a wheel's geom with another geom that its tread touches.
void addWheelContact(OdeWorld& ode, const OdeGeom& wheel, const OdeGeom& other, const dContactGeom& contact);
/// After ODE's step: updates loads, speeds and travel of all wheels from the forces of their contacts.
void settleWheels(OdeWorld& ode);
}  // namespace simcore
