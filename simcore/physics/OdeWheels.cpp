// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/physics/OdeWheels.h"

#include <algorithm>
#include <cmath>

#include "simcore/physics/OdeWorld.h"
#include "simcore/physics/Physics.h"

namespace simcore {
namespace {

// A tyre of about 40 kN/m that swings hardly. Being soft, it also shares the load between four wheels evenly.
constexpr double kTyreErrorReduction = 0.25;
constexpr double kTyreSoftness = 1.5e-3;
// Slower slip than this grips without sliding: a robot creeps down a slope by less than that. m/s
constexpr double kCreep = 0.0005;
constexpr double kLoadSmoothing = 0.5;
constexpr double kLeastLoad = 0.1;  // share of the load at rest: what is about to land grips a little
// A flank touches where the normal is this far along the axle.
constexpr double kFlank = 0.6;
constexpr double kAtLimit = 0.98;     // share of the motors' force
constexpr double kHardlyTurns = 0.3;  // share of the speed that was asked for

Vector3 toEigen(const dReal* v) {
  return {v[0], v[1], v[2]};
}

Vector3 velocityAt(dBodyID body, const Vector3& point) {
  if (body == nullptr) return Vector3::Zero();
  dVector3 velocity;
  dBodyGetPointVel(body, point.x(), point.y(), point.z(), velocity);
  return toEigen(velocity);
}

Vector3 rotated(dBodyID body, const Vector3& vector) {
  dVector3 result;
  dBodyVectorToWorld(body, vector.x(), vector.y(), vector.z(), result);
  return toEigen(result);
}

void copy(const Vector3& from, dReal* to) {
  for (int i = 0; i < 3; ++i) to[i] = from[i];
}

double loadOf(const OdeWorld& ode, const OdeWheelSide& side) {
  double sum = 0;
  for (std::size_t i = 0; i < side.wheelCount; ++i) sum += ode.wheels[side.firstWheel + i].load;
  return sum;
}

/// What one step told of a side's wheels.
struct SideForces {
  double force = 0, limit = 0, traction = 0;
  double treadSpeed = 0;  ///< sum over the contacts
  int contacts = 0;
};

void settleSide(OdeWheelSide& side, const SideForces& forces) {
  const double target = side.on ? side.target : 0;
  const bool limited = forces.contacts > 0 && forces.limit < forces.traction &&
                       std::abs(forces.force) >= kAtLimit * forces.limit;
  side.speed = limited ? forces.treadSpeed / forces.contacts : target;
  const bool blocked = limited && side.on && std::abs(side.speed) < kHardlyTurns * std::abs(target);
  side.blockedSteps = blocked ? side.blockedSteps + 1 : 0;
  side.travel += side.speed * Physics::kStepSeconds;
}

}  // namespace

bool isFlank(const OdeWorld& ode, const OdeGeom& wheel, const dContactGeom& contact) {
  const Vector3 axle =
      rotated(dGeomGetBody(wheel.id), ode.wheels[static_cast<std::size_t>(wheel.wheel)].axisInBody);
  return std::abs(toEigen(contact.normal).dot(axle)) > kFlank;
}

void addWheelContact(OdeWorld& ode, const OdeGeom& wheelGeom, const OdeGeom& otherGeom,
                     const dContactGeom& geometry) {
  const auto index = static_cast<std::size_t>(wheelGeom.wheel);
  const OdeWheel& wheel = ode.wheels[index];
  const OdeWheelSide& side = ode.wheelSides[wheel.side];
  const dBodyID body = dGeomGetBody(wheelGeom.id);
  const Vector3 normal = toEigen(geometry.normal), axle = rotated(body, wheel.axisInBody);
  OdeWheelContact& touch = ode.nextWheelContact();
  touch.wheel = index;
  touch.other = dGeomGetBody(otherGeom.id);
  touch.point = toEigen(geometry.pos);
  touch.normal = normal;
  touch.forward = axle.cross(normal).normalized();
  const Vector3 velocity = velocityAt(body, touch.point) - velocityAt(touch.other, touch.point);
  const double along = velocity.dot(touch.forward) - side.speed;
  const double across = velocity.dot(normal.cross(touch.forward));
  touch.traction = std::min(wheelGeom.friction, otherGeom.friction) * wheel.load;
  const double sideForce = side.on ? side.maximumForce : side.idleForce;
  touch.limit = sideForce * wheel.load / loadOf(ode, side);
  const double slipPerForce = std::max(std::hypot(along, across), kCreep) / std::max(touch.traction, 1e-6);
  touch.slipPerForce = slipPerForce * wheel.slipRatio;
  dContact contact{};
  contact.geom = geometry;
  copy(touch.forward, contact.fdir1);
  dSurfaceParameters& surface = contact.surface;
  surface.mode = dContactMu2 | dContactFDir1 | dContactMotion1 | dContactSlip1 | dContactSlip2 |
                 dContactSoftERP | dContactSoftCFM;
  surface.mu = std::min(touch.traction, touch.limit);
  surface.mu2 = touch.traction;
  surface.motion1 = side.on ? side.target : 0;
  surface.slip1 = touch.slipPerForce;
  surface.slip2 = slipPerForce;
  surface.soft_erp = kTyreErrorReduction;
  surface.soft_cfm = kTyreSoftness;
  const dJointID joint = dJointCreateContact(ode.world, ode.contacts, &contact);
  dJointAttach(joint, body, touch.other);
  dJointSetFeedback(joint, &touch.feedback);
}

void settleWheels(OdeWorld& ode) {
  if (ode.wheels.empty()) return;
  std::vector<SideForces> sides(ode.wheelSides.size());
  std::vector<double> loads(ode.wheels.size(), 0);
  for (std::size_t i = 0; i < ode.wheelContactCount; ++i) {
    const OdeWheelContact& touch = ode.wheelContacts[i];
    const OdeWheel& wheel = ode.wheels[touch.wheel];
    const Vector3 force = toEigen(touch.feedback.f1);
    const double along = force.dot(touch.forward);
    const Vector3 velocity =
        velocityAt(ode.bodies[wheel.body].id, touch.point) - velocityAt(touch.other, touch.point);
    loads[touch.wheel] += force.dot(touch.normal);
    SideForces& side = sides[wheel.side];
    side.force += along;
    side.limit += touch.limit;
    side.traction += touch.traction;
    side.treadSpeed += velocity.dot(touch.forward) + touch.slipPerForce * along;
    ++side.contacts;
  }
  for (std::size_t i = 0; i < loads.size(); ++i) {
    OdeWheel& wheel = ode.wheels[i];
    wheel.load += kLoadSmoothing * (loads[i] - wheel.load);
    wheel.load = std::max(wheel.load, kLeastLoad * wheel.restLoad);
  }
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const bool kinematic = ode.models[static_cast<std::size_t>(ode.drives[i / 2].model)].kinematic;
    if (!kinematic) settleSide(ode.wheelSides[i], sides[i]);
  }
}

Pose3 wheelLinkPose(const OdeWorld& ode, const OdeWheel& wheel) {
  const dBodyID body = ode.bodies[wheel.body].id;
  const double angle = std::remainder(ode.wheelSides[wheel.side].travel / wheel.radius, 2 * robotlink::kPi);
  return poseOf(dBodyGetPosition(body), dBodyGetRotation(body)) * wheel.linkInBody *
         Eigen::Translation3d(wheel.centerInLink) * Eigen::AngleAxisd(angle, wheel.axisInLink) *
         Eigen::Translation3d(-wheel.centerInLink);
}

}  // namespace simcore
