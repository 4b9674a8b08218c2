// SPDX-License-Identifier: GPL-3.0-or-later
// Drives and their wheels as OdeWorld holds them; OdeWheels.h says how they move.
#pragma once

#include <ode/ode.h>

#include "simcore/physics/Footprint.h"
#include "simcore/world/WorldDescription.h"

namespace simcore {

/// The wheels on one side of a drive: belts let them turn alike.
struct OdeWheelSide {
  std::size_t firstWheel = 0, wheelCount = 0;  ///< of OdeWorld::wheels
  double maximumForce = 0, idleForce = 0;      ///< N, of all its rims
  double target = 0;                           ///< m/s
  bool on = true;
  double speed = 0, travel = 0;  ///< of the rims, m/s and m
  int blockedSteps = 0;          ///< for how many steps it has been at its limit and hardly turned
};

struct OdeWheel {
  std::size_t body = 0;                   ///< that carries it, of OdeWorld::bodies
  std::size_t side = 0;                   ///< of OdeWorld::wheelSides
  Pose3 linkInBody = Pose3::Identity();   ///< at angle 0; in ODE's body, whose origin is its centre of mass
  Vector3 axisInBody = Vector3::UnitY();  ///< forwards is right-handed about it
  Vector3 axisInLink = Vector3::UnitY();
  Vector3 centerInLink = Vector3::Zero();  ///< of its cylinder, about which the link turns
  double radius = 0;
  double slipRatio = 1;  ///< of slip along to slip across at equal force
  double restLoad = 0;   ///< N that it carries if all wheels carry alike
  double load = 0;       ///< N that it carries
};

/// Where a wheel touched in this step.
struct OdeWheelContact {
  std::size_t wheel = 0;
  dBodyID other = nullptr;
  Vector3 point, normal, forward;
  double slipPerForce = 0;  ///< m/s per N, along
  double traction = 0;      ///< N, what the ground would take
  double limit = 0;         ///< N, what the motors give it
  dJointFeedback feedback{};
};

/// Wheels on two sides of a model.
struct OdeDrive {
  int model = 0;
  std::size_t body = 0;  ///< that carries the wheels, of OdeWorld::bodies
  double track = 0;
  Vector3 centerInBody = Vector3::Zero();  ///< between the wheels
  Vector3 axisInBody = Vector3::UnitY();   ///< of the axles, to the left
  double radius = 0;  ///< of a circle about the centre that holds the model, seen from above
  // For a model that is moved by its odometry:
  std::size_t place = 0;               ///< of OdeWorld::places
  Footprint footprint;                 ///< seen from its centre, x to the front
  bool touches = false;                ///< something, where it is
  robotlink::Vector2 freeAt = {0, 0};  ///< where it was last looked how far away obstacles are
  double freeWay = 0;                  ///< and how far it can go from there
};

}  // namespace simcore
