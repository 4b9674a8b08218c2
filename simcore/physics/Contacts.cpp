// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/physics/Contacts.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "simcore/physics/FreeBodies.h"
#include "simcore/physics/OdeGeoms.h"
#include "simcore/physics/OdeWheels.h"

namespace simcore {
namespace {

constexpr int kMaxContacts = 4;
/// With a mesh, whose triangles each give contacts: the first four may all be at one corner of a body.
constexpr int kMaxMeshContacts = 24;
constexpr double kContactErrorReduction = 0.3;
/// For bodies up to 1 kg; it is less for heavier ones, which would sink in otherwise instead of bouncing.
constexpr double kContactSoftness = 1e-5;
/// From this speed on, m/s, what touches slides.
constexpr double kSlides = 0.02;
constexpr double kMinBounceVelocity = 0.05;  // m/s
/// The upward component of a contact's normal from which the other solid is a floor or a ramp rather than an
/// obstacle.
constexpr double kFloor = 0.7;

dGeomID asGeom(dSpaceID space) {
  return reinterpret_cast<dGeomID>(space);
}

OdeModel& modelOf(OdeWorld& ode, const OdeGeom& geom) {
  return ode.models[static_cast<std::size_t>(geom.model)];
}

/// The body that a contact moves; null if there is none.
dBodyID movedBody(OdeWorld& ode, const OdeGeom& geom) {
  return modelOf(ode, geom).kinematic ? nullptr : dGeomGetBody(geom.id);
}

/// Whether no force can move the solids in a space. Its data is its OdeModel; the space of statics has none.
bool isUnmoved(dGeomID space) {
  const auto* model = static_cast<const OdeModel*>(dGeomGetData(space));
  return model == nullptr || model->kinematic;
}

/// `upward` is that share of the contact's normal.
void noteTouch(OdeWorld& ode, OdeGeom& a, OdeGeom& b, double upward) {
  ode.touch(a);
  ode.touch(b);
  OdeModel &first = modelOf(ode, a), &second = modelOf(ode, b);
  const bool bothMove = first.space != nullptr && second.space != nullptr;
  if (bothMove) ode.touches.emplace_back(std::minmax(a.model, b.model));
  if (bothMove || std::abs(upward) < kFloor) first.touchesObstacle = second.touchesObstacle = true;
}

/// The mass that two bodies that meet have together: the reciprocal of the sum of their reciprocals, kg. Null
/// is a body that does not move.
double reducedMass(dBodyID a, dBodyID b) {
  double reciprocals = 0;
  for (const dBodyID body : {a, b}) {
    if (body == nullptr) continue;
    dMass mass;
    dBodyGetMass(body, &mass);
    reciprocals += 1 / mass.mass;
  }
  return reciprocals > 0 ? 1 / reciprocals : 0;
}

/// Directs friction against the way in which one body slides on the other. Without that, ODE's friction is up
/// to the square root of 2 too large in directions between its two axes.
void opposeSliding(dContact& contact, dBodyID a, dBodyID b) {
  Vector3 velocity = Vector3::Zero();
  const dReal* at = contact.geom.pos;
  for (const dBodyID body : {a, b}) {
    if (body == nullptr) continue;
    dVector3 own;
    dBodyGetPointVel(body, at[0], at[1], at[2], own);
    velocity += (body == a ? 1 : -1) * Vector3(own[0], own[1], own[2]);
  }
  const Vector3 normal(contact.geom.normal[0], contact.geom.normal[1], contact.geom.normal[2]);
  const Vector3 along = velocity - normal * normal.dot(velocity);
  const double speed = along.norm();
  if (!(speed > kSlides)) return;
  contact.surface.mode |= dContactFDir1;
  for (int i = 0; i < 3; ++i) contact.fdir1[i] = along[i] / speed;
}

/// The part of addContacts() for wheels.
void addRolling(OdeWorld& ode, OdeGeom& wheel, OdeGeom& other) {
  dContactGeom contact;
  if (dCollide(wheel.id, other.id, 1, &contact, sizeof contact) == 0 || isFlank(ode, wheel, contact)) return;
  addWheelContact(ode, wheel, other, contact);
  noteTouch(ode, wheel, other, contact.normal[2]);
}

void addContacts(void* data, dGeomID a, dGeomID b) {
  auto& ode = *static_cast<OdeWorld*>(data);
  if (dGeomIsSpace(a) != 0 && dGeomIsSpace(b) != 0 && isUnmoved(a) && isUnmoved(b)) return;
  if (descend(&ode, a, b, &addContacts)) return;
  OdeGeom& first = infoOf(a);
  OdeGeom& second = infoOf(b);
  if (first.wheel >= 0 && movedBody(ode, first) != nullptr) return addRolling(ode, first, second);
  if (second.wheel >= 0 && movedBody(ode, second) != nullptr) return addRolling(ode, second, first);
  dContact contacts[kMaxMeshContacts];
  const int most =
      first.triangles != nullptr || second.triangles != nullptr ? kMaxMeshContacts : kMaxContacts;
  const int count = dCollide(a, b, most, &contacts[0].geom, sizeof(dContact));
  if (count == 0) return;
  noteTouch(ode, first, second, contacts[0].geom.normal[2]);
  const dBodyID bodyA = movedBody(ode, first), bodyB = movedBody(ode, second);
  const double softness = kContactSoftness / std::max(1.0, reducedMass(bodyA, bodyB));
  for (int i = 0; i < count; ++i) {
    dSurfaceParameters& surface = contacts[i].surface;
    surface.mode = dContactApprox1 | dContactSoftERP | dContactSoftCFM;
    surface.mu = std::min(first.friction, second.friction);
    surface.soft_erp = kContactErrorReduction;
    surface.soft_cfm = softness;
    surface.bounce = std::max(first.restitution, second.restitution);
    surface.bounce_vel = kMinBounceVelocity;
    if (surface.bounce > 0) surface.mode |= dContactBounce;
    opposeSliding(contacts[i], bodyA, bodyB);
    countContact(bodyA);
    countContact(bodyB);
    const dJointID joint = dJointCreateContact(ode.world, ode.contacts, &contacts[i]);
    dJointAttach(joint, bodyA, bodyB);
  }
}

/// Whether a contact of a geom is that of a wheel with the ground, or with the wheel's flank.
bool isOnlyRolling(const OdeWorld& ode, const OdeGeom& geom, const dContactGeom& contact) {
  return geom.wheel >= 0 && (std::abs(contact.normal[2]) > kFloor || isFlank(ode, geom, contact));
}

/// Whether a geom is a wheel that need not be compared: a kinematic model does not stand on it, and its other
/// solids are as wide.
bool isHiddenWheel(OdeWorld& ode, const OdeGeom& geom) {
  return geom.wheel >= 0 && modelOf(ode, geom).kinematic;
}

bool mayMeet(const OdeWorld& ode, const OdePlace& a, const OdePlace& b) {
  const auto position = [&](const OdePlace& place) {
    return dBodyGetPosition(ode.bodies[ode.models[static_cast<std::size_t>(place.model)].firstBody].id);
  };
  const dReal *p = position(a), *q = position(b);
  const double dx = p[0] - q[0], dy = p[1] - q[1], reach = a.radius + b.radius;
  return dx * dx + dy * dy <= reach * reach;
}

struct OverlapQuery {
  OdeWorld& ode;
  int model;
  NoteTouches note;
  Overlap found{};
};

void compareDepth(void* data, dGeomID a, dGeomID b) {
  auto& query = *static_cast<OverlapQuery*>(data);
  if (descend(&query, a, b, &compareDepth)) return;
  OdeGeom &first = infoOf(a), &second = infoOf(b);
  if (isHiddenWheel(query.ode, first) || isHiddenWheel(query.ode, second)) return;
  dContactGeom contacts[kMaxContacts];
  const int count = dCollide(a, b, kMaxContacts, contacts, sizeof(dContactGeom));
  bool noted = query.note == NoteTouches::kNo;
  for (int i = 0; i < count; ++i) {
    const dContactGeom& contact = contacts[i];
    if (isOnlyRolling(query.ode, first, contact) || isOnlyRolling(query.ode, second, contact)) continue;
    if (!noted) noteTouch(query.ode, first, second, contact.normal[2]);
    noted = true;
    if (contact.depth > query.found.depth) {
      query.found = {contact.depth, first.model == query.model ? second.model : first.model};
    }
  }
}

struct TouchQuery {
  int model;
  std::set<int> found{};
};

void noteModel(void* data, dGeomID a, dGeomID b) {
  auto& query = *static_cast<TouchQuery*>(data);
  if (descend(&query, a, b, &noteModel)) return;
  const OdeGeom &first = infoOf(a), &second = infoOf(b);
  const int other = first.model == query.model ? second.model : first.model;
  dContactGeom contact;
  if (!query.found.contains(other) && dCollide(a, b, 1, &contact, sizeof contact) > 0)
    query.found.insert(other);
}

/// Calls `callback` for a moving model's space and each geom or space that may touch it.
template <typename Query>
void compareWithOthers(OdeWorld& ode, int model, Query& query, dNearCallback* callback) {
  const dSpaceID own = ode.models[static_cast<std::size_t>(model)].space;
  const OdePlace& place = *std::ranges::lower_bound(ode.places, model, {}, &OdePlace::model);
  for (const OdePlace& other : ode.places) {
    // ODE's bounds are not used: asking for them makes ODE update all solids of everything that moves.
    if (other.model == model || !mayMeet(ode, place, other)) continue;
    const OdeModel& otherModel = ode.models[static_cast<std::size_t>(other.model)];
    dSpaceCollide2(asGeom(own), asGeom(otherModel.space), &query, callback);
  }
  StaticGrid::Bounds bounds;
  dGeomGetAABB(asGeom(own), bounds.data());
  ode.grid.near(bounds, ode.nearby);
  for (const dGeomID geom : ode.nearby) dSpaceCollide2(asGeom(own), geom, &query, callback);
  for (const dGeomID geom : ode.grid.unbounded()) dSpaceCollide2(asGeom(own), geom, &query, callback);
}

}  // namespace

std::vector<int> touchingModels(OdeWorld& ode, int model) {
  TouchQuery query{model};
  if (ode.models[static_cast<std::size_t>(model)].space != nullptr)
    compareWithOthers(ode, model, query, &noteModel);
  return {query.found.begin(), query.found.end()};
}

void findContacts(OdeWorld& ode) {
  if (!ode.hasDynamic) return;
  dSpaceCollide(ode.top, &ode, &addContacts);
  if (!ode.usesGrid) return;
  StaticGrid::Bounds bounds;
  for (const OdeModel& model : ode.models) {
    if (model.space == nullptr || model.kinematic) continue;
    dGeomGetAABB(asGeom(model.space), bounds.data());
    ode.grid.near(bounds, ode.nearby);
    for (const dGeomID geom : ode.nearby) dSpaceCollide2(asGeom(model.space), geom, &ode, &addContacts);
  }
}

Overlap deepestOverlap(OdeWorld& ode, int model, NoteTouches note) {
  OverlapQuery query{ode, model, note};
  if (ode.models[static_cast<std::size_t>(model)].space == nullptr) return query.found;
  compareWithOthers(ode, model, query, &compareDepth);
  return query.found;
}

}  // namespace simcore
