// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/physics/OdeGuideBuilder.h"

namespace simcore {
namespace {

constexpr dReal kAxes[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

/// A motor along axes of the world.
dJointID addPush(dWorldID world, dBodyID body, int axes) {
  const dJointID push = dJointCreateLMotor(world, nullptr);
  dJointAttach(push, body, nullptr);
  dJointSetLMotorNumAxes(push, axes);
  for (int i = 0; i < axes; ++i) dJointSetLMotorAxis(push, i, 0, kAxes[i][0], kAxes[i][1], kAxes[i][2]);
  return push;
}

/// A motor about all axes of the world, or about the vertical one.
dJointID addTurn(dWorldID world, dBodyID body, bool all) {
  const dJointID turn = dJointCreateAMotor(world, nullptr);
  dJointAttach(turn, body, nullptr);
  dJointSetAMotorMode(turn, dAMotorUser);
  dJointSetAMotorNumAxes(turn, all ? 3 : 1);
  for (int i = all ? 0 : 2; i < 3; ++i)
    dJointSetAMotorAxis(turn, all ? i : 0, 0, kAxes[i][0], kAxes[i][1], kAxes[i][2]);
  return turn;
}

}  // namespace

void addGuide(OdeWorld& ode, const GuidedMotion& motion, OdeModel& model) {
  const bool isFree = motion.kind == GuidedMotion::Kind::kFree;
  const bool isHeld = isFree || motion.kind == GuidedMotion::Kind::kWalk;
  const dBodyID body = ode.bodies[model.firstBody].id;
  model.push = addPush(ode.world, body, isHeld ? 3 : 2);
  model.turn = addTurn(ode.world, body, isHeld);
  if (!isHeld) return;
  for (std::size_t i = model.firstBody; i < ode.bodies.size(); ++i) {
    if (ode.hasBody(i)) dBodySetGravityMode(ode.bodies[i].id, 0);
  }
}

}  // namespace simcore
