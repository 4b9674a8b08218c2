// SPDX-License-Identifier: GPL-3.0-or-later
// Drives and wheels as OdeWorld stores them; OdeWheels.h describes how they work.
#pragma once

#include <ode/ode.h>

#include "simcore/physics/shapes/Footprint.h"
#include "simcore/world/WorldDescription.h"

namespace simcore {

/// The wheels on one side of a drive; they have the same speed, as if coupled by belts.
struct OdeWheelSide {
  /// A range of OdeWorld::wheels.
  std::size_t firstWheel = 0, wheelCount = 0;
  int model = 0;
  /// Force of all its rims together with and without power, N.
  double maximumForce = 0, idleForce = 0;
  /// Requested speed of the rims, m/s.
  double target = 0;
  /// Whether the motors have power.
  bool on = true;
  /// Speed and travel of the rims, m/s and m.
  double speed = 0, travel = 0;
  /// Mechanical power of its motors in the last step, W.
  double power = 0;
  /// For how many steps it has been at its force limit and has hardly turned.
  int blockedSteps = 0;
};

/// A driven wheel. It has no ODE body of its own.
struct OdeWheel {
  /// The body that carries it, an index of OdeWorld::bodies.
  std::size_t body = 0;
  /// An index of OdeWorld::wheelSides.
  std::size_t side = 0;
  /// The wheel's link at angle 0, relative to ODE's body, whose origin is its center of mass.
  Pose3 linkInBody = Pose3::Identity();
  /// A right-handed rotation about it drives forwards.
  Vector3 axisInBody = Vector3::UnitY();
  /// The same axis in the wheel's link.
  Vector3 axisInLink = Vector3::UnitY();
  Vector3 centerInLink = Vector3::Zero();  ///< of its cylinder, about which the link turns
  double radius = 0;
  /// Slip along the rolling direction divided by slip across it at equal force.
  double slipRatio = 1;
  /// Whether its rim has free rollers, and the angle from the rolling direction to that in which they push.
  bool hasRollers = false;
  double pushAngle = 0;
  /// The wheel's share of the weight if all wheels carry equally, N.
  double restLoad = 0;
  /// The present load of the wheel, N.
  double load = 0;
};

/// The contact of a wheel in this step.
struct OdeWheelContact {
  std::size_t wheel = 0;
  /// The body that it touches; null if that is static.
  dBodyID other = nullptr;
  /// In the world; `forward` is the rolling direction, or that in which the wheel's rollers push.
  Vector3 point, normal, forward;
  /// Slip along the rolling direction, m/s per N.
  double slipPerForce = 0;
  /// The most that the ground can transmit, N.
  double traction = 0;
  /// The most that the motors can exert, N.
  double limit = 0;
  /// How fast the tread moves along `forward`, as a share of the rim's speed.
  double share = 1;
  /// ODE writes the forces of the contact here.
  dJointFeedback feedback{};
};

/// A drive: the wheels on the two sides of a model.
struct OdeDrive {
  int model = 0;
  /// The left one of its two OdeWorld::wheelSides.
  std::size_t firstSide = 0;
  /// The body that carries the wheels, an index of OdeWorld::bodies.
  std::size_t body = 0;
  /// Meters.
  double track = 0;
  /// The middle between the wheels.
  Vector3 centerInBody = Vector3::Zero();
  /// The axles' direction, to the left.
  Vector3 axisInBody = Vector3::UnitY();
  /// Radius of the circle around the center that contains the model, seen from above.
  double radius = 0;
  // Only for a model that follows its odometry:
  /// An index of OdeWorld::places.
  std::size_t place = 0;
  /// Relative to its center, x to the front.
  Footprint footprint;
  /// Whether it touches something at its present pose.
  bool touches = false;
  /// The place where the distance of obstacles was last computed...
  robotlink::Vector2 freeAt = {0, 0};
  /// ...and how far the model can move from there without meeting a static obstacle.
  double freeWay = 0;
};

}  // namespace simcore
