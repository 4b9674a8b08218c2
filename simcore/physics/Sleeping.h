// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies that rest are not computed until something touches or moves them.
//
// Models sleep that have no wheels and that nothing guides and no joint ties to the world, together with all
// such models that they touch, directly or through others: when all bodies of each of them have stayed within
// fractions of a millimeter for half a second on at least three points, and none touches anything else that
// can move. A robot sleeps while its servos are asked for what they do already. Their contacts stay as
// they were, as do the forces; those of joints are the mean of the time at rest. ODE's own
// auto-disabling would let a body sleep on one that moves slowly, forgets contacts, and keeps counters that
// cannot be read for a snapshot.
#pragma once

#include "simcore/physics/OdeWorld.h"

namespace simcore {

class StateStream;

/// Wakes a model, if it sleeps, and all that fell asleep with it.
void wake(OdeWorld& ode, OdeModel& model);

/// Call this before a motor is set: wakes its model, if that sleeps and the motor is driven otherwise.
void wakeIfDrivenOtherwise(OdeWorld& ode, std::size_t hinge, double speed, double limit);

/// Wakes what is touched by a pair of this step that is awake. Returns whether anything slept; then the
/// contacts have to be found again.
bool wakeTouched(OdeWorld& ode);

/// Whether a body may fall asleep after this step, so that the forces of its contacts will be kept; it may be
/// null.
bool mayFallAsleep(dBodyID body);

/// After a step: lets models sleep.
void letModelsSleep(OdeWorld& ode);

/// Writes or reads which models sleep, and which are about to.
void transferSleep(StateStream& stream, OdeWorld& ode);

}  // namespace simcore
