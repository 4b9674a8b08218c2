// SPDX-License-Identifier: GPL-3.0-or-later
// Physics: the state that a step leaves behind, and going back to it.
//
// ODE has no functions for this. Its state from step to step is the motion of its bodies, bit by bit: its
// setters normalize rotations again, which changes their last bits, so the bits are written where ODE has
// them. All else is derived from them, set before each step (motors), or empty between steps (contacts,
// forces). Its spaces keep their geoms in an order that depends on how they moved before; findContacts() does
// not depend on this order.
#include <algorithm>

#include "simcore/physics/OdeWorld.h"
#include "simcore/physics/Physics.h"
#include "simcore/physics/Sleeping.h"
#include "simcore/world/StateStream.h"

namespace simcore {
namespace {

/// The tolerance of rotations in a file.
constexpr double kRotationTolerance = 1e-6;
/// The maximum speeds in a file, m/s and rad/s; a faster body has left the world long ago.
constexpr double kMaxMotion = 1e4;

/// Overwrites what ODE has of a body, which it returns as constant.
void overwrite(const dReal* in, const dReal* values, std::size_t count) {
  std::copy_n(values, count, const_cast<dReal*>(in));
}

void numbers(StateStream& stream, dReal* values, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) stream.number(values[i]);
}

bool isRotation(const dQuaternion q, const dMatrix3 r) {
  const Eigen::Quaterniond quaternion(q[0], q[1], q[2], q[3]);
  if (!(std::abs(quaternion.norm() - 1) < kRotationTolerance)) return false;
  Eigen::Matrix3d matrix;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) matrix(row, column) = r[4 * row + column];
  }
  return (quaternion.toRotationMatrix() - matrix).norm() < 10 * kRotationTolerance;
}

void transferBody(StateStream& stream, dBodyID body) {
  dVector3 position, velocity, rate;
  dQuaternion q;
  dMatrix3 r;
  std::copy_n(dBodyGetPosition(body), 3, position);
  std::copy_n(dBodyGetQuaternion(body), 4, q);
  std::copy_n(dBodyGetRotation(body), 12, r);
  std::copy_n(dBodyGetLinearVel(body), 3, velocity);
  std::copy_n(dBodyGetAngularVel(body), 3, rate);
  numbers(stream, position, 3);
  numbers(stream, q, 4);
  numbers(stream, r, 12);
  for (dReal* motion : {velocity, rate})
    for (int i = 0; i < 3; ++i) stream.within(motion[i], -kMaxMotion, kMaxMotion);
  if (!stream.isReading()) return;
  stream.require(isRotation(q, r));
  if (!stream.good()) return;
  // Also has ODE note that the geoms have moved.
  dBodySetPosition(body, position[0], position[1], position[2]);
  dBodySetQuaternion(body, q);
  overwrite(dBodyGetQuaternion(body), q, 4);
  overwrite(dBodyGetRotation(body), r, 12);
  dBodySetLinearVel(body, velocity[0], velocity[1], velocity[2]);
  dBodySetAngularVel(body, rate[0], rate[1], rate[2]);
  dBodySetForce(body, 0, 0, 0);
  dBodySetTorque(body, 0, 0, 0);
}

void transferSide(StateStream& stream, OdeWheelSide& side) {
  stream.number(side.target);
  stream.flag(side.on);
  stream.number(side.speed);
  // Travel adds up, and so does the number of steps.
  stream.within(side.travel, -1e12, 1e12);
  stream.within(side.power, 0, 1e12);
  stream.raw(side.blockedSteps);
  stream.require(side.blockedSteps >= 0 && side.blockedSteps < (1 << 30));
}

void transferDrive(StateStream& stream, OdeDrive& drive) {
  stream.flag(drive.touches);
  stream.number(drive.freeAt.x());
  stream.number(drive.freeAt.y());
  // Only what was searched is known to be free, so that a file cannot lead a robot through a wall.
  double freeWay = drive.freeWay;
  stream.number(freeWay);
  drive.freeWay = stream.isReading() ? 0 : drive.freeWay;
}

void transferForces(StateStream& stream, dJointFeedback& force) {
  for (dReal* part : {force.f1, force.t1, force.f2, force.t2})
    for (int i = 0; i < 3; ++i) stream.within(part[i], -1e15, 1e15);
}

void transferFollower(StateStream& stream, OdeFollower& follower, std::size_t joints) {
  for (double* command : {&follower.ahead, &follower.sideways, &follower.turning}) stream.number(*command);
  stream.flag(follower.stopped);
  // The resting state in the file is not needed: it follows from the bodies.
  bool known = follower.known;
  stream.flag(known);
  if (!known) {
    follower.known = false;
    return;
  }
  for (double* number :
       {&follower.place.x, &follower.place.y, &follower.place.heading, &follower.height, &follower.ground})
    stream.number(*number);
  for (int i = 0; i < 9; ++i) stream.within(follower.lean.data()[i], -1, 1);
  follower.joints.resize(joints);
  for (double& joint : follower.joints) stream.number(joint);
  follower.known = stream.good();
}

}  // namespace

void Physics::transferTouches(StateStream& stream) {
  OdeWorld& ode = *ode_;
  if (stream.isReading()) ode.touchedGeoms.clear();
  for (OdeGeom& geom : ode.geoms) {
    stream.flag(geom.touched);
    if (stream.isReading() && geom.touched) ode.touchedGeoms.push_back(&geom);
  }
  for (OdeModel& model : ode.models) stream.flag(model.touchesObstacle);
  stream.size(ode.touches, std::size_t{1} << 24U);
  for (auto& [first, second] : ode.touches) {
    stream.raw(first);
    stream.raw(second);
    const auto count = static_cast<int>(ode.models.size());
    stream.require(first >= 0 && first < count && second >= 0 && second < count);
  }
  if (stream.isReading() && !stream.good()) ode.touches.clear();
}

void Physics::transfer(StateStream& stream) {
  prepareOdeForThread();
  OdeWorld& ode = *ode_;
  for (std::size_t i = 0; i < ode.bodies.size(); ++i) {
    if (!ode.hasBody(i)) continue;
    bool isPinned = ode.bodies[i].pinned;
    stream.flag(isPinned);
    if (stream.isReading()) setPinned(i, isPinned);
    transferBody(stream, ode.bodies[i].id);
  }
  transferSleep(stream, ode);
  for (dJointFeedback& force : ode.hingeForces) transferForces(stream, force);
  for (OdeMeasuredJoint& joint : ode.measuredJoints) transferForces(stream, joint.force);
  for (OdeWheel& wheel : ode.wheels) stream.within(wheel.load, 0, 1e12);
  for (OdeWheelSide& side : ode.wheelSides) transferSide(stream, side);
  for (OdeDrive& drive : ode.drives) {
    transferDrive(stream, drive);
    stream.flag(ode.models[static_cast<std::size_t>(drive.model)].hasGround);
  }
  for (OdeFollower& follower : ode.followers) {
    const ModelInstance& model = ode.description.models[static_cast<std::size_t>(follower.model)];
    transferFollower(stream, follower, model.type->joints.size());
  }
  transferTouches(stream);
  if (stream.isReading()) ode.contactRecords.clear();
}

}  // namespace simcore
