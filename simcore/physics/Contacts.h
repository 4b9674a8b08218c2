// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simcore/physics/OdeWorld.h"

namespace simcore {

/// Finds what touches now, notes it in geoms, models and `touches`, and makes contact joints of it for ODE's
/// next step. What no force can move (static models, and models that are moved by their odometry) is not
/// compared with its like.
void findContacts(OdeWorld& ode);

/// How deep a model sinks into others, floors under its wheels apart.
struct Overlap {
  double depth = 0;  ///< m, of the deepest contact; 0 if there is none
  int model = -1;    ///< the one that it sinks into; -1 if there is none
};
enum class NoteTouches : std::uint8_t { kNo, kYes };

/// Compares a moving model with everything static near it, and with all other moving models whose bounds meet
/// its own. With kYes, what touches is noted as findContacts() does.
Overlap deepestOverlap(OdeWorld& ode, int model, NoteTouches note = NoteTouches::kNo);

}  // namespace simcore
