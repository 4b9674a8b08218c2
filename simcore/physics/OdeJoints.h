// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "simcore/physics/OdeWorld.h"

namespace simcore {

/// Creates a joint of a model whose bodies exist, at their poses with all joints at 0. Wheels of drives have
/// none.
void addJoint(OdeWorld& ode, const ModelInstance& model, const JointDescription& joint,
              std::size_t firstBody);

/// Before each step: makes passive joints resist. Viscous resistance is a motor that brakes with at most
/// damping times the present speed, which is stable for any step, unlike a torque computed from the speed.
void resist(OdeWorld& ode);

/// The position of a hinge or a slider, by its index in OdeWorld::hinges: m or rad, -pi to pi. ODE's own
/// angle of a hinge contains how far its axes are tilted against each other, which near 0 lets it leap
/// between two values of opposite signs, 3 mrad apart for the head of an ERS-210, so that a servo would never
/// rest.
double jointPosition(const OdeWorld& ode, std::size_t hinge);
// The speed of a joint, and its axis in the world.
double jointRate(dJointID joint);
Vector3 jointAxis(dJointID joint);
/// Returns the point of reference of a joint's reaction, in the world: the anchor of a hinge, the center of
/// mass of a slider's child.
Vector3 jointAnchor(dJointID joint);
/// Moves it at a speed with at most this torque or force.
void driveJoint(dJointID joint, double speed, double limit);
/// The values set by driveJoint().
struct MotorSetting {
  double speed = 0, limit = 0;
};
MotorSetting motorOf(dJointID joint);

}  // namespace simcore
