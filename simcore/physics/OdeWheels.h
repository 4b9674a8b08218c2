// SPDX-License-Identifier: GPL-3.0-or-later
// Driven wheels in ODE; for Physics and what belongs to it only.
//
// A wheel is no body of its own. Its mass is lumped into the body that carries it, and where it touches, the
// contact itself drives: the tread moves with the wheels' speed along the rolling direction, with a force
// that the side's motors limit. So a robot with four wheels is one body with four contacts instead of five
// bodies with four hinges, which costs a third and needs fewer iterations.
//
// Grip is Coulomb's: a tyre that slides is pulled against the direction in which it slides, by friction times
// load. ODE's own friction limits the two directions apart; with it, wheels that turn on the spot would roll
// without sliding and scrub sideways, and the robot would turn about the distance of its wheels. Here each
// direction's force is proportional to its share of the slip, by a factor that the slip of the last step
// gives (ODE's force-dependent slip, solved implicitly).
//
// What a skid-steered robot turns about follows. Let its wheels be at (+-a, +-b), s the slip of their treads
// and k the ratio of slip along to slip across at equal force. Turning on the spot at w, tyres slide by w a
// across and s along; the forces balance if s b = k w a^2, so rims run at w b + s, and the track is 2 (b + k
// a^2 / b). k is chosen so that this is the model's track.
#pragma once

#include <ode/ode.h>

#include "simcore/physics/OdeWorld.h"

namespace simcore {

/// Whether it is only its flank by which a wheel touches something: a wheel is a sphere to ODE.
bool isFlank(const OdeWorld& ode, const OdeGeom& wheel, const dContactGeom& contact);
/// Adds the contact of a wheel's geom with another one, to which its flank is not turned.
void addWheelContact(OdeWorld& ode, const OdeGeom& wheel, const OdeGeom& other, const dContactGeom& contact);
/// After ODE's step: loads, speeds and travels of all wheels by what their contacts carried.
void settleWheels(OdeWorld& ode);
}  // namespace simcore
