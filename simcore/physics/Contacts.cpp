// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/physics/Contacts.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "simcore/physics/FreeBodies.h"
#include "simcore/physics/OdeGeoms.h"
#include "simcore/physics/OdeWheels.h"
#include "simcore/physics/Sleeping.h"
#include "simcore/world/WorldSize.h"

namespace simcore {
namespace {

constexpr int kMaxContacts = 4;
/// With a mesh, whose triangles each give contacts: the first four may all be at one corner of a body.
constexpr int kMaxMeshContacts = 24;
constexpr double kContactErrorReduction = 0.3;
/// For bodies up to 1 kg; it is less for heavier ones, which would sink in otherwise instead of bouncing.
constexpr double kContactSoftness = 1e-5;
/// From this speed on, m/s, touching solids slide.
constexpr double kSlides = 0.02;
constexpr double kMinBounceVelocity = 0.05;  // m/s
/// The upward component of a contact's normal from which the other solid is a floor or a ramp rather than an
/// obstacle.
constexpr double kFloor = 0.7;
/// The overlap to which a solid that is pushed is limited, m, unless it cannot get away.
constexpr double kSqueezed = 0.004;

dGeomID asGeom(dSpaceID space) {
  return reinterpret_cast<dGeomID>(space);
}

OdeModel& modelOf(OdeWorld& ode, const OdeGeom& geom) {
  return ode.models[static_cast<std::size_t>(geom.model)];
}

/// The body that a contact moves, or that moves with the contact; null if there is none.
dBodyID movedBody(OdeWorld& ode, const OdeGeom& geom) {
  const OdeModel& model = modelOf(ode, geom);
  return model.kinematic && model.follower < 0 ? nullptr : dGeomGetBody(geom.id);
}

/// Whether a geom is a wheel that rolls by forces.
bool rolls(OdeWorld& ode, const OdeGeom& geom) {
  return geom.wheel >= 0 && !modelOf(ode, geom).kinematic;
}

/// The cause of motion of the solids in a space. Its data is its OdeModel; the space of statics has none.
enum class MovedBy : std::uint8_t { kNothing, kCommands, kForces, kSleeps };
MovedBy movedBy(dGeomID space) {
  const auto* model = static_cast<const OdeModel*>(dGeomGetData(space));
  if (model == nullptr) return MovedBy::kNothing;
  if (model->kinematic) return MovedBy::kCommands;
  return model->isAsleep() ? MovedBy::kSleeps : MovedBy::kForces;
}

/// Whether contacts between the solids of two spaces change nothing, or are known.
bool needNoContacts(dGeomID a, dGeomID b) {
  const MovedBy first = movedBy(a), second = movedBy(b);
  if (first == MovedBy::kForces || second == MovedBy::kForces) return false;
  // A sleeping model is woken by one that approaches.
  const bool sleeps = first == MovedBy::kSleeps || second == MovedBy::kSleeps;
  return !sleeps || (first != MovedBy::kCommands && second != MovedBy::kCommands);
}

/// `upward` is that share of the contact's normal.
void noteTouch(OdeWorld& ode, OdeGeom& a, OdeGeom& b, double upward) {
  ode.touch(a);
  ode.touch(b);
  OdeModel &first = modelOf(ode, a), &second = modelOf(ode, b);
  const bool bothMove = first.space != nullptr && second.space != nullptr;
  if (bothMove) ode.touches.emplace_back(std::minmax(a.model, b.model));
  if (!bothMove && std::abs(upward) >= kFloor) return;
  first.touchesObstacle = second.touchesObstacle = true;
  if (a.body != OdeGeom::kNoBody) ode.obstacleTouches.push_back({a.body, b.model});
  if (b.body != OdeGeom::kNoBody) ode.obstacleTouches.push_back({b.body, a.model});
}

/// The effective mass of two bodies that meet: the reciprocal of the sum of their reciprocals, kg. Null
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
  dContact contact{};
  if (dCollide(wheel.id, other.id, 1, &contact.geom, sizeof(dContact)) == 0 ||
      isFlank(ode, wheel, contact.geom))
    return;
  ode.pairs.push_back({&wheel, &other, ode.found.size(), 1, true});
  ode.found.push_back(contact);
  noteTouch(ode, wheel, other, contact.geom.normal[2]);
}

void addContacts(void* data, dGeomID a, dGeomID b) {
  auto& ode = *static_cast<OdeWorld*>(data);
  if (dGeomIsSpace(a) != 0 && dGeomIsSpace(b) != 0 && needNoContacts(a, b)) return;
  if (descend(&ode, a, b, &addContacts)) return;
  // ODE passes them in an order that depends on how they moved before.
  if (infoOf(b).index < infoOf(a).index) std::swap(a, b);
  OdeGeom& first = infoOf(a);
  OdeGeom& second = infoOf(b);
  if (rolls(ode, first)) return addRolling(ode, first, second);
  if (rolls(ode, second)) return addRolling(ode, second, first);
  const int most =
      first.triangles != nullptr || second.triangles != nullptr ? kMaxMeshContacts : kMaxContacts;
  dContact contacts[kMaxMeshContacts];
  const int count = dCollide(a, b, most, &contacts[0].geom, sizeof(dContact));
  if (count == 0) return;
  noteTouch(ode, first, second, contacts[0].geom.normal[2]);
  ode.pairs.push_back({&first, &second, ode.found.size(), static_cast<std::size_t>(count), false});
  ode.found.insert(ode.found.end(), contacts, contacts + count);
}

/// Has the force of a contact be written where it is read.
void record(OdeWorld& ode, const OdePair& pair, const dContactGeom& contact, const dJointFeedback* exerted) {
  OdeContactRecord& record = ode.contactRecords.emplace_back();
  record.first = pair.first;
  record.second = pair.second;
  record.point = {contact.pos[0], contact.pos[1], contact.pos[2]};
  record.normal = {contact.normal[0], contact.normal[1], contact.normal[2]};
  record.depth = contact.depth;
  // ODE exchanges the bodies where the first one is none.
  record.sign = movedBody(ode, *pair.first) != nullptr ? 1 : -1;
  record.exerted = exerted;
}

/// Creates the contact joints of a pair.
void addJoints(OdeWorld& ode, const OdePair& pair) {
  if (pair.rolls) {
    const dContactGeom& contact = ode.found[pair.firstContact].geom;
    addWheelContact(ode, *pair.first, *pair.second, contact);
    if (ode.readsContacts) record(ode, pair, contact, &ode.wheelContacts[ode.wheelContactCount - 1].feedback);
    return;
  }
  const dBodyID bodyA = movedBody(ode, *pair.first), bodyB = movedBody(ode, *pair.second);
  const double softness = kContactSoftness / std::max(1.0, reducedMass(bodyA, bodyB));
  for (std::size_t i = pair.firstContact; i < pair.firstContact + pair.count; ++i) {
    dContact& contact = ode.found[i];
    dSurfaceParameters& surface = contact.surface;
    surface.mode = dContactApprox1 | dContactSoftERP | dContactSoftCFM;
    surface.mu = std::min(pair.first->friction, pair.second->friction);
    surface.soft_erp = kContactErrorReduction;
    surface.soft_cfm = softness;
    surface.bounce = std::max(pair.first->restitution, pair.second->restitution);
    surface.bounce_vel = kMinBounceVelocity;
    if (surface.bounce > 0) surface.mode |= dContactBounce;
    opposeSliding(contact, bodyA, bodyB);
    countContact(bodyA);
    countContact(bodyB);
    const dJointID joint = dJointCreateContact(ode.world, ode.contacts, &contact);
    dJointAttach(joint, bodyA, bodyB);
    ++ode.contactCount;
    if (!ode.readsContacts && !mayFallAsleep(bodyA) && !mayFallAsleep(bodyB)) continue;
    dJointFeedback& exerted = ode.contactForces.emplace_back();
    dJointSetFeedback(joint, &exerted);
    record(ode, pair, contact.geom, &exerted);
  }
}

/// Creates the contact joints of a step in an order that depends on nothing but which geoms touch, so that a
/// simulation that was put back to an earlier state continues as it did then.
void addJointsInOrder(OdeWorld& ode) {
  std::ranges::sort(ode.pairs, {}, &OdePair::key);
  ode.contactRecords.clear();
  ode.contactForces.clear();
  for (const OdePair& pair : ode.pairs) addJoints(ode, pair);
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
  /// Floors do not count.
  bool sideways = false;
  /// Models that can be moved may be overlapped a little.
  bool pushes = false;
  Overlap found{};
  /// Solids that overlap less are not counted, m.
  double tolerance = 0;
  std::vector<OverlappingPair> overlapping{};
};

/// How deep a contact counts as one that is in the way, m.
double obstructingDepth(const OverlapQuery& query, int other, const dContactGeom& contact) {
  if (query.sideways && std::abs(contact.normal[2]) > kFloor) return 0;
  const OdeModel& model = query.ode.models[static_cast<std::size_t>(other)];
  const bool givesWay = query.pushes && model.space != nullptr && !model.kinematic;
  return givesWay ? std::max(0.0, contact.depth - kSqueezed) : contact.depth;
}

void compareDepth(void* data, dGeomID a, dGeomID b) {
  auto& query = *static_cast<OverlapQuery*>(data);
  if (query.found.pairs >= kMaxOverlaps || descend(&query, a, b, &compareDepth)) return;
  OdeGeom &first = infoOf(a), &second = infoOf(b);
  if (isHiddenWheel(query.ode, first) || isHiddenWheel(query.ode, second)) return;
  dContactGeom contacts[kMaxContacts];
  const int count = dCollide(a, b, kMaxContacts, contacts, sizeof(dContactGeom));
  const dContactGeom* touch = nullptr;
  double deepest = 0;
  for (int i = 0; i < count; ++i) {
    const dContactGeom& contact = contacts[i];
    if (isOnlyRolling(query.ode, first, contact) || isOnlyRolling(query.ode, second, contact)) continue;
    if (touch == nullptr) touch = &contact;
    const int other = first.model == query.model ? second.model : first.model;
    const double depth = obstructingDepth(query, other, contact);
    deepest = std::max(deepest, depth);
    if (depth > query.found.depth) query.found = {depth, other, query.found.pairs};
  }
  if (deepest > query.tolerance) ++query.found.pairs;
  if (touch == nullptr) return;
  query.overlapping.push_back({&first, &second, touch->normal[2], deepest});
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

namespace {

/// Compares all moving models with the static geoms near them.
void findContactsInGrid(OdeWorld& ode) {
  StaticGrid::Bounds bounds;
  for (const OdeModel& model : ode.models) {
    if (model.space == nullptr || model.kinematic || model.isAsleep()) continue;
    dGeomGetAABB(asGeom(model.space), bounds.data());
    ode.grid.near(bounds, ode.nearby);
    for (const dGeomID geom : ode.nearby) dSpaceCollide2(asGeom(model.space), geom, &ode, &addContacts);
  }
}

}  // namespace

namespace {

void findPairs(OdeWorld& ode) {
  ode.pairs.clear();
  ode.found.clear();
  dSpaceCollide(ode.top, &ode, &addContacts);
  if (ode.usesGrid) findContactsInGrid(ode);
}

}  // namespace

void findContacts(OdeWorld& ode) {
  ode.pairs.clear();
  ode.found.clear();
  if (!ode.hasDynamic) return;
  do findPairs(ode);
  while (wakeTouched(ode));
  for (const OdeAsleepContact& one : ode.asleepContacts) {
    if (one.isFirstOfPair) noteTouch(ode, ode.geoms[one.first], ode.geoms[one.second], one.normal.z());
  }
  addJointsInOrder(ode);
}

Overlap deepestOverlap(OdeWorld& ode, int model, NoteTouches note, double tolerance) {
  OverlapQuery query{ode, model};
  query.tolerance = tolerance;
  if (ode.models[static_cast<std::size_t>(model)].space == nullptr) return query.found;
  compareWithOthers(ode, model, query, &compareDepth);
  if (note == NoteTouches::kYes) noteTouches(ode, query.overlapping);
  return query.found;
}

std::vector<OverlappingPair> pairsInWay(OdeWorld& ode, const OdeFollower& follower) {
  OverlapQuery query{ode, follower.model, follower.travels, follower.pushes};
  compareWithOthers(ode, follower.model, query, &compareDepth);
  return std::move(query.overlapping);
}

void noteTouches(OdeWorld& ode, const std::vector<OverlappingPair>& pairs) {
  for (const OverlappingPair& pair : pairs) noteTouch(ode, *pair.first, *pair.second, pair.upward);
}

}  // namespace simcore
