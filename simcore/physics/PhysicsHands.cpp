// SPDX-License-Identifier: GPL-3.0-or-later
// Physics: acting on bodies by hand, and reading the forces of contacts and joints.
#include <Eigen/Eigenvalues>
#include <algorithm>

#include "simcore/physics/OdeJoints.h"
#include "simcore/physics/OdeWorld.h"
#include "simcore/physics/Physics.h"
#include "simcore/physics/Sleeping.h"

namespace simcore {

void Physics::setPinned(std::size_t body, bool pinned) {
  OdeBody& one = ode_->bodies[carrierOf(body)];
  if (one.pinned == pinned) return;
  wakeBody(body);
  one.pinned = pinned;
  if (!pinned) {
    // Computes with the mass again that the body has kept.
    dBodySetDynamic(one.id);
    return;
  }
  dBodySetKinematic(one.id);
  dBodySetLinearVel(one.id, 0, 0, 0);
  dBodySetAngularVel(one.id, 0, 0, 0);
}

void Physics::wakeBody(std::size_t body) {
  for (OdeModel& model : ode_->models) {
    if (body >= model.firstBody && body < model.firstBody + model.bodyCount) return wake(*ode_, model);
  }
}

bool Physics::isAsleep(int model) const {
  return ode_->models[static_cast<std::size_t>(model)].isAsleep();
}

bool Physics::isPinned(std::size_t body) const {
  return ode_->bodies[carrierOf(body)].pinned;
}

bool Physics::isMovedByForces(int model) const {
  const OdeModel& entry = ode_->models[static_cast<std::size_t>(model)];
  return entry.space != nullptr && !entry.kinematic;
}

void Physics::throwModel(int model, const Vector3& velocity, const Vector3& rate) {
  OdeModel& entry = ode_->models[static_cast<std::size_t>(model)];
  wake(*ode_, entry);
  const auto forEach = [&](auto visit) {
    for (std::size_t i = entry.firstBody; i < entry.firstBody + entry.bodyCount; ++i) {
      if (!ode_->hasBody(i)) continue;
      const dReal* at = dBodyGetPosition(ode_->bodies[i].id);
      visit(ode_->bodies[i], Vector3(at[0], at[1], at[2]));
    }
  };
  double mass = 0;
  Vector3 center = Vector3::Zero();
  forEach([&](const OdeBody& body, const Vector3& position) {
    dMass own;
    dBodyGetMass(body.id, &own);
    mass += own.mass;
    center += own.mass * position;
  });
  center /= mass;
  forEach([&](const OdeBody& body, const Vector3& position) {
    if (body.pinned) return;
    const Vector3 speed = velocity + rate.cross(position - center);
    dBodySetLinearVel(body.id, speed.x(), speed.y(), speed.z());
    dBodySetAngularVel(body.id, rate.x(), rate.y(), rate.z());
  });
}

void Physics::addForce(std::size_t body, const Vector3& force, const Vector3& point) {
  wakeBody(body);
  dBodyAddForceAtPos(ode_->bodies[body].id, force.x(), force.y(), force.z(), point.x(), point.y(), point.z());
}

double Physics::massAt(std::size_t body, const Vector3& point) const {
  const dReal* at = dBodyGetPosition(ode_->bodies[body].id);
  const double squared = (point - Vector3(at[0], at[1], at[2])).squaredNorm();
  dMass mass;
  dBodyGetMass(ode_->bodies[body].id, &mass);
  const Eigen::Matrix3d inertia{{mass.I[0], mass.I[1], mass.I[2]},
                                {mass.I[4], mass.I[5], mass.I[6]},
                                {mass.I[8], mass.I[9], mass.I[10]}};
  const double least = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(inertia).eigenvalues()[0];
  return 1 / (1 / mass.mass + squared / std::max(least, 1e-12));
}

std::pair<std::size_t, std::size_t> Physics::bodiesOf(int model) const {
  const OdeModel& entry = ode_->models[static_cast<std::size_t>(model)];
  return {entry.firstBody, entry.bodyCount};
}

std::size_t Physics::carrierOf(std::size_t body) const {
  return ode_->bodies[body].carrier;
}

void Physics::readContacts(bool on) {
  ode_->readsContacts = on;
  if (!on) ode_->contactRecords.clear();
}

std::vector<Physics::Contact> Physics::contacts() const {
  const auto bodyOf = [this](const OdeGeom& geom) -> std::optional<std::size_t> {
    if (geom.body == OdeGeom::kNoBody || dGeomGetBody(geom.id) == nullptr) return std::nullopt;
    return geom.wheel < 0 ? geom.body : carrierOf(geom.body);
  };
  std::vector<Contact> result;
  result.reserve(ode_->contactRecords.size() + ode_->asleepContacts.size());
  for (const OdeContactRecord& record : ode_->contactRecords) {
    const dReal* force = record.exerted->f1;
    result.push_back({record.first->model, record.second->model, bodyOf(*record.first),
                      bodyOf(*record.second), record.point, record.normal, record.depth,
                      record.sign * Vector3(force[0], force[1], force[2])});
  }
  for (const OdeAsleepContact& one : ode_->asleepContacts) {
    if (!ode_->readsContacts) break;
    const OdeGeom &first = ode_->geoms[one.first], &second = ode_->geoms[one.second];
    result.push_back({first.model, second.model, bodyOf(first), bodyOf(second), one.point, one.normal,
                      one.depth, one.force});
  }
  return result;
}

Vector3 Physics::anchorOf(std::size_t hinge) const {
  return jointAnchor(ode_->hinges[hinge]);
}

}  // namespace simcore
