// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/physics/OdeWheels.h"

#include <algorithm>
#include <cmath>

#include "simcore/physics/Step.h"

namespace simcore {
namespace {

// A tire with about 40 kN/m that hardly oscillates. Because it is soft, four wheels share the load evenly.
constexpr double kTireErrorReduction = 0.25;
constexpr double kTireSoftness = 1.5e-3;
// Slip slower than this, in m/s, is grip without sliding: a robot creeps down a slope more slowly than that.
constexpr double kCreep = 0.0005;
/// The rollers of a rim resist with this share of what it can transmit.
constexpr double kRollerResistance = 0.02;
constexpr double kLoadSmoothing = 0.5;
/// The minimum load as a fraction of that at rest: a wheel that is about to land grips a little.
constexpr double kMinLoad = 0.1;
// A contact is with the flank if the axial component of its normal is larger than this.
constexpr double kFlank = 0.6;
/// Fraction of the motors' maximum force.
constexpr double kAtLimit = 0.98;
/// Fraction of the requested speed.
constexpr double kHardlyTurns = 0.3;

Vector3 fromOde(const dReal* v) {
  return {v[0], v[1], v[2]};
}

Vector3 velocityAt(dBodyID body, const Vector3& point) {
  if (body == nullptr) return Vector3::Zero();
  dVector3 velocity;
  dBodyGetPointVel(body, point.x(), point.y(), point.z(), velocity);
  return fromOde(velocity);
}

Vector3 rotatedByBody(dBodyID body, const Vector3& vector) {
  dVector3 result;
  dBodyVectorToWorld(body, vector.x(), vector.y(), vector.z(), result);
  return fromOde(result);
}

void copy(const Vector3& from, dReal* to) {
  for (int i = 0; i < 3; ++i) to[i] = from[i];
}

double loadOf(const OdeWorld& ode, const OdeWheelSide& side) {
  double sum = 0;
  for (std::size_t i = 0; i < side.wheelCount; ++i) sum += ode.wheels[side.firstWheel + i].load;
  return sum;
}

/// The sums over the contacts of a side's wheels in one step.
struct SideForces {
  double force = 0, limit = 0, traction = 0;
  // The sum over the contacts.
  double treadSpeed = 0;
  int contacts = 0;
};

void settleSide(OdeWheelSide& side, const SideForces& forces) {
  const double target = side.on ? side.target : 0;
  const bool limited = forces.contacts > 0 && forces.limit < forces.traction &&
                       std::abs(forces.force) >= kAtLimit * forces.limit;
  side.speed = limited ? forces.treadSpeed / forces.contacts : target;
  const bool blocked = limited && side.on && std::abs(side.speed) < kHardlyTurns * std::abs(target);
  side.blockedSteps = blocked ? side.blockedSteps + 1 : 0;
  side.travel += side.speed * kStepSeconds;
  side.power = side.on ? std::abs(forces.force * side.speed) : 0;
}

}  // namespace

bool isFlank(const OdeWorld& ode, const OdeGeom& wheel, const dContactGeom& contact) {
  const Vector3 axle =
      rotatedByBody(dGeomGetBody(wheel.id), ode.wheels[static_cast<std::size_t>(wheel.wheel)].axisInBody);
  return std::abs(fromOde(contact.normal).dot(axle)) > kFlank;
}

void addWheelContact(OdeWorld& ode, const OdeGeom& wheelGeom, const OdeGeom& otherGeom,
                     const dContactGeom& geometry) {
  const auto index = static_cast<std::size_t>(wheelGeom.wheel);
  const OdeWheel& wheel = ode.wheels[index];
  const OdeWheelSide& side = ode.wheelSides[wheel.side];
  const dBodyID body = dGeomGetBody(wheelGeom.id);
  const Vector3 normal = fromOde(geometry.normal), axle = rotatedByBody(body, wheel.axisInBody);
  OdeWheelContact& touch = ode.nextWheelContact();
  touch.wheel = index;
  touch.other = dGeomGetBody(otherGeom.id);
  touch.point = fromOde(geometry.pos);
  touch.normal = normal;
  touch.forward = axle.cross(normal).normalized();
  touch.share = 1;
  if (wheel.hasRollers) {
    touch.forward = Eigen::AngleAxisd(wheel.pushAngle, normal) * touch.forward;
    touch.share = std::cos(wheel.pushAngle);
  }
  const Vector3 velocity = velocityAt(body, touch.point) - velocityAt(touch.other, touch.point);
  const double along = velocity.dot(touch.forward) - side.speed * touch.share;
  const double across = velocity.dot(normal.cross(touch.forward));
  touch.traction = std::min(wheelGeom.friction, otherGeom.friction) * wheel.load;
  const double sideForce = side.on ? side.maximumForce : side.idleForce;
  touch.limit = sideForce / touch.share * wheel.load / loadOf(ode, side);
  // Across, rollers roll instead of sliding.
  const double slip = wheel.hasRollers ? std::abs(along) : std::hypot(along, across);
  const double slipPerForce = std::max(slip, kCreep) / std::max(touch.traction, 1e-6);
  touch.slipPerForce = slipPerForce * wheel.slipRatio;
  dContact contact{};
  contact.geom = geometry;
  copy(touch.forward, contact.fdir1);
  dSurfaceParameters& surface = contact.surface;
  surface.mode = dContactMu2 | dContactFDir1 | dContactMotion1 | dContactSlip1 | dContactSlip2 |
                 dContactSoftERP | dContactSoftCFM;
  surface.mu = std::min(touch.traction, touch.limit);
  surface.mu2 = wheel.hasRollers ? kRollerResistance * touch.traction : touch.traction;
  surface.motion1 = side.on ? side.target * touch.share : 0;
  surface.slip1 = touch.slipPerForce;
  surface.slip2 = slipPerForce;
  surface.soft_erp = kTireErrorReduction;
  surface.soft_cfm = kTireSoftness;
  const dJointID joint = dJointCreateContact(ode.world, ode.contacts, &contact);
  dJointAttach(joint, body, touch.other);
  ++ode.contactCount;
  dJointSetFeedback(joint, &touch.feedback);
}

void settleWheels(OdeWorld& ode) {
  if (ode.wheels.empty()) return;
  std::vector<SideForces> sides(ode.wheelSides.size());
  std::vector<double> loads(ode.wheels.size(), 0);
  for (std::size_t i = 0; i < ode.wheelContactCount; ++i) {
    const OdeWheelContact& touch = ode.wheelContacts[i];
    const OdeWheel& wheel = ode.wheels[touch.wheel];
    const Vector3 force = fromOde(touch.feedback.f1);
    const double along = force.dot(touch.forward);
    const Vector3 velocity =
        velocityAt(ode.bodies[wheel.body].id, touch.point) - velocityAt(touch.other, touch.point);
    loads[touch.wheel] += force.dot(touch.normal);
    SideForces& side = sides[wheel.side];
    side.force += along * touch.share;
    side.limit += touch.limit * touch.share;
    side.traction += touch.traction * touch.share;
    side.treadSpeed += (velocity.dot(touch.forward) + touch.slipPerForce * along) / touch.share;
    ++side.contacts;
  }
  for (std::size_t i = 0; i < loads.size(); ++i) {
    OdeWheel& wheel = ode.wheels[i];
    wheel.load += kLoadSmoothing * (loads[i] - wheel.load);
    wheel.load = std::max(wheel.load, kMinLoad * wheel.restLoad);
  }
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const bool kinematic = ode.models[static_cast<std::size_t>(ode.wheelSides[i].model)].kinematic;
    if (!kinematic) settleSide(ode.wheelSides[i], sides[i]);
  }
}

}  // namespace simcore
