// SPDX-License-Identifier: GPL-3.0-or-later
// Inverse kinematics of wheeled vehicles: wheel speeds and steering angles for a commanded motion. Pure
// functions.
#pragma once

#include <array>

#include "simcore/world/ActuatorDescription.h"

namespace simcore {

/// How a model moves in the plane: the velocity of its origin along its own axes, m/s, and rad/s.
struct PlaneMotion {
  double ahead = 0, sideways = 0, turning = 0;
};

/// Limits a command to what the model can do: speeds, and a steering angle. A torque is not limited here.
std::array<double, 6> limitedCommand(const GuidedMotion& motion, const VehicleDescription& vehicle,
                                     std::array<double, 6> command);

/// The motion that a command is meant to yield, if no wheel slips; not for commands of torques.
PlaneMotion motionOf(const GuidedMotion& motion, const VehicleDescription* vehicle,
                     const std::array<double, 6>& command);

/// The angle by which a steered wheel must be turned to the left, rad, so that its axis goes through the
/// center of the turn (Ackermann's geometry): the angle of the command is that of a wheel in the middle.
double steeringAngle(const GuidedMotion& motion, const VehicleWheel& wheel, double commanded);

/// The speed of a wheel's rim, m/s, for a command of speeds.
double rimSpeed(const GuidedMotion& motion, const VehicleDescription& vehicle, const VehicleWheel& wheel,
                const std::array<double, 6>& command);

}  // namespace simcore
