// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simcore/physics/OdeWorld.h"

namespace simcore {

/// Finds all contacts, records them in geoms, models and `touches`, and creates contact joints for ODE's next
/// step. Pairs that no force can move (static models, models that follow their odometry) are not compared.
void findContacts(OdeWorld& ode);

/// How deep a model overlaps others, not counting the floor under its wheels.
struct Overlap {
  /// The deepest contact, m; 0 if there is none.
  double depth = 0;
  /// The model that it overlaps; -1 if there is none.
  int model = -1;
  /// How many pairs of solids overlap; at most kMaxOverlaps are looked at.
  std::size_t pairs = 0;
};

/// Whether a query records the contacts it finds.
enum class NoteTouches : std::uint8_t { kNo, kYes };

/// Compares a moving model with the static geoms near it and with all other moving models whose bounds meet
/// its own. With kYes, contacts are recorded as by findContacts(), but get no joints.
/// Pairs of solids are counted that overlap by more than `tolerance`, m.
Overlap deepestOverlap(OdeWorld& ode, int model, NoteTouches note = NoteTouches::kNo, double tolerance = 0);

/// Two solids that overlap.
struct OverlappingPair {
  OdeGeom* first = nullptr;
  OdeGeom* second = nullptr;
  /// The vertical share of the normal of their first contact.
  double upward = 0;
  /// How deep they are in the way of each other, m.
  double depth = 0;
};

/// The overlaps of the solids of a kinematic model. For what travels, floors and ramps are not in the way. If
/// it pushes, models that can be moved are in the way only where they are squeezed.
std::vector<OverlappingPair> pairsInWay(OdeWorld& ode, const OdeFollower& follower);

/// Records contacts as findContacts() does, but they get no joints.
void noteTouches(OdeWorld& ode, const std::vector<OverlappingPair>& pairs);

/// The models, in ascending order, that a moving model touches.
std::vector<int> touchingModels(OdeWorld& ode, int model);

}  // namespace simcore
