// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simcore/physics/OdeWorld.h"

namespace simcore {

/// Makes a model follow its commands; all its bodies, joints and wheels must exist.
void addFollower(OdeWorld& ode, const ModelInstance& model, int index);

/// Before contacts are searched: puts each following model where it goes in this step, with its joints where
/// their motors turn them, or leaves it where it is if it would run into something. The lowest solid of one
/// that travels stays on the ground, to which it is lowered at first. To the solver, its bodies are of
/// infinite mass and move with the velocities of this step, so they push others and are not pushed.
void moveFollowers(OdeWorld& ode);
/// After ODE's step, which has moved them on: puts them back.
void settleFollowers(OdeWorld& ode);

}  // namespace simcore
