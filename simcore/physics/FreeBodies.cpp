// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/physics/FreeBodies.h"

#include <algorithm>
#include <cmath>

#include "simcore/physics/Step.h"

namespace simcore {
namespace {

/// Moments of inertia that differ by a smaller share are equal, and there is no gyroscopic torque.
constexpr double kSameMoments = 1e-6;
/// Half of the angle by which a step may turn the body's smallest moment; the iteration contracts by it.
constexpr double kMaxHalfTurn = 0.3;
/// With that contraction, the error of the last one is 1e-8 of the first.
constexpr int kTurnIterations = 16;

/// rad/s.
constexpr double kNoTurn = 1e-3;
// Below these speeds a body is at rest: m/s, and rad/s.
constexpr double kRests = 0.001, kRestsTurning = 0.01;

bool isSlower(const dReal* velocity, double limit) {
  return velocity[0] * velocity[0] + velocity[1] * velocity[1] + velocity[2] * velocity[2] < limit * limit;
}

Eigen::Matrix3d matrixOf(const dReal* values) {
  Eigen::Matrix3d matrix;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) matrix(row, column) = values[4 * row + column];
  }
  return matrix;
}

/// Turns a vector by half a step of an angular velocity, backwards.
Vector3 turnedBack(const Vector3& vector, const Vector3& rate) {
  const double angle = rate.norm() * kStepSeconds / 2;
  if (angle < 1e-12) return vector;
  return Eigen::AngleAxisd(-angle, rate.normalized()) * vector;
}

void turnFreely(dBodyID body) {
  dMass mass;
  dBodyGetMass(body, &mass);
  const Eigen::Matrix3d rotation = matrixOf(dBodyGetRotation(body));
  const Eigen::Matrix3d inertia = rotation * matrixOf(mass.I) * rotation.transpose();
  const dReal* velocity = dBodyGetAngularVel(body);
  const Vector3 before(velocity[0], velocity[1], velocity[2]);
  const Vector3 momentum = turnedBack(inertia * before, before);
  const Eigen::Matrix3d inverse = inertia.inverse();
  const bool isSlow = momentum.norm() * inverse.norm() * kStepSeconds / 2 < kMaxHalfTurn;
  dBodySetGyroscopicMode(body, isSlow ? 0 : 1);
  if (!isSlow) return;
  Vector3 rate = before;
  for (int i = 0; i < kTurnIterations; ++i) rate = inverse * turnedBack(momentum, rate);
  const Vector3 torque = inertia * (rate - before) / kStepSeconds;
  dBodyAddTorque(body, torque.x(), torque.y(), torque.z());
}

}  // namespace

void addFreeBody(OdeWorld& ode, dBodyID body, bool maySleep) {
  const bool isJointed = dBodyGetNumJoints(body) > 0;
  if (isJointed && !maySleep) return;
  OdeFreeBody& added = ode.freeBodies.emplace_back();
  added.id = body;
  added.isJointed = isJointed;
  dMass mass;
  dBodyGetMass(body, &mass);
  const Eigen::Matrix3d inertia = matrixOf(mass.I);
  const Eigen::Matrix3d even = Eigen::Matrix3d::Identity() * inertia.trace() / 3;
  added.wobbles = (inertia - even).norm() > kSameMoments * inertia.norm();
  dBodySetData(body, &added);
}

void prepareFreeBodies(OdeWorld& ode) {
  for (OdeFreeBody& body : ode.freeBodies) {
    body.contacts = 0;
    if (body.isJointed || dBodyIsEnabled(body.id) == 0) continue;
    std::copy_n(dBodyGetPosition(body.id), 3, body.position);
    std::copy_n(dBodyGetQuaternion(body.id), 4, body.rotation);
    if (!body.wobbles) continue;
    // A body at rest needs no torque of ours; ODE's is as good, whatever was done before.
    if (isSlower(dBodyGetAngularVel(body.id), kNoTurn))
      dBodySetGyroscopicMode(body.id, 1);
    else
      turnFreely(body.id);
  }
}

void countContact(dBodyID body) {
  if (body == nullptr) return;
  if (auto* free = static_cast<OdeFreeBody*>(dBodyGetData(body)); free != nullptr) ++free->contacts;
}

void letFreeBodiesRest(OdeWorld& ode) {
  for (const OdeFreeBody& body : ode.freeBodies) {
    if (body.isJointed || dBodyIsEnabled(body.id) == 0 || body.contacts < kStands ||
        !isSlower(dBodyGetLinearVel(body.id), kRests) ||
        !isSlower(dBodyGetAngularVel(body.id), kRestsTurning))
      continue;
    dBodySetPosition(body.id, body.position[0], body.position[1], body.position[2]);
    dBodySetQuaternion(body.id, body.rotation);
    dBodySetLinearVel(body.id, 0, 0, 0);
    dBodySetAngularVel(body.id, 0, 0, 0);
  }
}

}  // namespace simcore
